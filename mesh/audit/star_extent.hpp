// SPDX-License-Identifier: MIT
//
// Bounds how far the sites that matter to a star extend along covectors.
//
// For every covector g, a site w that a gap of v's star accepts has
//   g . (w - v) <= E(|g|_w),   |g|_w^2 = g M_w^-1 g,
// where E is a convex, increasing function (docs/math/certificate.md, section 4.3):
//   E(l) = (|g|_v + max(|g|_v, l)) R, with R no less than the reach of each gap, or
//   E(l) = max(0, g . p + l length(p)) over the points p of the outline of the gaps.
// Two lines bound it from above. The covectors are a free choice: x, y, x + y and x - y, the same
// for all stars, and one of the star's own, along which its metric's unit circle extends least.
#pragma once

#include <span>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/covectors.hpp"
#include "asterism/mesh/audit/star_outline.hpp"

namespace asterism::internal::audit_detail {

// Upper bound of a convex, increasing function of a length, for one covector or all four: the first
// line up to some length, and the second from there on.
template <class Number>
struct extent_lines {
  Number none, rise;  // value at the length 0, and slope
  Number far, steep;

  Number at(const Number& length) const {
    return greater_of(none + rise * length, far + steep * length);
  }
};

// Bounds along a covector, or all four, and along its opposite.
template <class Number>
struct both_extents {
  extent_lines<Number> forth, back;
};

class star_extent {
 public:
  // Sites whose values of the four covectors are not in a box do not matter.
  struct box {
    by_covector least, greatest;

    bool excludes(const point& q) const {
      return any_outside(pair(q.x, q.y), least.axes, greatest.axes) ||
             any_outside(pair(q.x + q.y, q.x - q.y), least.diagonals, greatest.diagonals);
    }
    // True if one covector excludes all values from `low` to `high`.
    bool excludes(const by_covector& low, const by_covector& high) const {
      return any_less(high.axes, least.axes) || any_less(greatest.axes, low.axes) ||
             any_less(high.diagonals, least.diagonals) ||
             any_less(greatest.diagonals, low.diagonals);
    }
  };

  // Bounds the star of v by a reach of its gaps, a length in v's metric. With an infinite one all
  // sites matter.
  star_extent(const site& v, double reach);
  // Bounds the star of v by the outline of its gaps, which must outlive this object.
  star_extent(const site& v, std::span<const outline_point> outline);
  // Covers the extents of several stars, at least one; takes the own covector of the first.
  explicit star_extent(std::span<const star_extent> stars);

  // The centre of the star, or of the first.
  const site& v() const { return v_; }
  // Returns the box of sites in whose metrics the covectors are no longer than this. `lost` is at
  // least the errors of the values that will be compared.
  box box_for(const by_covector& length, double lost) const {
    const by_covector margin = all_of(lost);
    return {-(by_four_.back.at(length) + margin), by_four_.forth.at(length) + margin};
  }
  const point& own() const { return own_; }
  // False if is_beyond_own() is false for these values with any length: an extent is least at the
  // length 0. Decides the sites near v without the length in their metrics.
  bool may_be_beyond_own(double least, double greatest) const {
    return least > by_own_.forth.none || -greatest > by_own_.back.none;
  }
  // True if sites w do not matter whose values of the own covector at w - v are from `least` to
  // `greatest`, if it is no longer than `length` in their metrics.
  bool is_beyond_own(double least, double greatest, double length) const {
    return least > by_own_.forth.at(length) || -greatest > by_own_.back.at(length);
  }

 private:
  star_extent(const site& v, double reach, std::span<const outline_point> outline);
  // Return the extents along the four covectors, as values at w, and along any covector, at w - v.
  both_extents<by_covector> along_four(const by_covector& own_length) const;
  both_extents<double> along(const point& g, double inverse_determinant) const;

  site v_;
  double reach_;
  std::span<const outline_point> outline_;  // in place of the reach, unless empty
  point own_;
  by_covector length_of_four_;  // in v's metric, at least
  both_extents<by_covector> by_four_;
  both_extents<double> by_own_;
};

}  // namespace asterism::internal::audit_detail
