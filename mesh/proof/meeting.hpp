// SPDX-License-Identifier: MIT
//
// Decides what is shown at a place where the bisectors of four sites meet, or nearly: that two of
// the sites keep each other and the other two do not (docs/math/proof-format.md, theorems 8 and 9).
// The place itself need not be a point of any grid, or even rational.
//
// Notation: the gap from x counter-clockwise to y in the star of v, and w beyond the edge x-y. The
// box is the parallelogram n + s (c1 - n) + t (c2 - n), s and t from 0 to 1, whose corner m across
// from n is where a row around the gap turns.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/proof/star_conditions.hpp"
#include "asterism/mesh/proof/whole.hpp"

namespace asterism::internal::proof_detail {

struct meeting_sites {
  const site &v, &x, &y, &w;
};

// Three corners of a box, in steps of the edges from v to x and to y.
struct meeting_box {
  grid_point c1, m, c2;
};

// A polynomial in s and t of degree 2 at most: the coefficients of 1, s, t, ss, st, tt.
template <class Number>
using box_polynomial = std::array<Number, 6>;
inline constexpr std::array<std::pair<int, int>, 6> box_powers = {std::pair(0, 0), std::pair(1, 0),
                                                                  std::pair(0, 1), std::pair(2, 0),
                                                                  std::pair(1, 1), std::pair(0, 2)};

// The sites with offsets from v and tensors that are whole multiples of powers of two, and the box
// in the units of these offsets.
class meeting_plane {
 public:
  using vector = vector2<whole>;

  meeting_plane(const meeting_sites& sites, const meeting_box& box);

  // f_z - f_v on the box, for x, y and w.
  const std::array<box_polynomial<whole>, 3>& excess() const { return excess_; }
  // True if these angles between directions are below 90 degrees for every point of the box, in the
  // metric of the site they are at: at v and at w between the point and x, and the point and y; at
  // x between the point and y; at y between the point and x. And neither v nor w may be in a closed
  // triangle of x, y and a point of the box.
  bool is_seen() const;

 private:
  struct whole_site {
    vector at;
    whole m11, m12, m22;
  };

  static whole product(const whole_site& of, const vector& p, const vector& q);
  box_polynomial<whole> expansion(const whole_site& of) const;
  bool is_outside(const whole_site& z, int side) const;

  std::array<whole_site, 4> sites_;  // v, x, y, w
  std::array<vector, 4> corners_;    // n, c1, m, c2
  std::array<box_polynomial<whole>, 3> excess_;
};

// Returns the number of coefficients of one weight in the list of three weights' coefficients; 0 if
// the list has no valid length.
std::size_t weight_size(std::span<const whole> weights);

// True if one point of the box is equally far from v, x and y, and is_seen() holds.
bool has_meeting(const meeting_plane& plane);

// True if the weights of x, y and w, each of 1, 3 or 6 coefficients, show that x and y keep each
// other between v and w, and that v accepts w at no point of the box.
bool is_edge_at_meeting(const meeting_sites& sites, const meeting_box& box,
                        std::span<const whole> weights);

}  // namespace asterism::internal::proof_detail
