// SPDX-License-Identifier: MIT
//
// Excludes sites from gaps of a star by the gaps' outline.
//
// A site w that a gap accepts meets the gap's kite (docs/math/certificate.md, section 4.3): for
// every covector g,
//   g . (w - v) <= max(0, g . p + |g|_w length(p)) over the points p,
// where the points are the corners of the kite other than v, with their distances from v, and the
// two neighbours, with the length 0. So a site for which one covector exceeds that for all points
// is accepted in no gap. The covector is a free choice: here that of the way to w from the nearest
// point, in the metric of w or in a lower bound of the metrics of several sites.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// A point relative to v.
struct outline_point {
  point at;
  double length = 0;  // no less than its distance from v, or 0 for a neighbour
};

// A lower bound of the metrics of some sites, as quadratic forms: tensor / factor.
struct least_metric {
  metric_tensor tensor;
  double factor = 1;
};

// Box of all displacements from v to some sites.
struct offset_box {
  point low, high;
};

// True if certainly no site in the box `to`, with a metric of at least `metric`, is accepted in
// gaps with this outline: `vertices` of their kites, at least one, from which the covector is
// chosen, and its other points.
bool are_outside(const offset_box& to, const least_metric& metric,
                 std::span<const outline_point> vertices, std::span<const outline_point> others);

// The points of some gaps of a fan.
class star_outline {
 public:
  void clear() {
    vertices_.clear();
    others_.clear();
  }
  // Adds the corner of a gap's kite that is neither v nor on the way to a neighbour.
  void add_vertex(const outline_point& p) { vertices_.push_back(p); }
  // Adds a neighbour, and the point up to which the way to it belongs to the kites.
  void add_neighbour(const point& at, const outline_point& on_way) {
    others_.push_back(on_way);
    others_.push_back({at, 0});
  }

  // True if certainly no site in this box, with a metric of at least `metric`, is accepted in one
  // of the gaps.
  bool excludes(const offset_box& to, const least_metric& metric) const {
    return !vertices_.empty() && are_outside(to, metric, vertices_, others_);
  }
  // Calls take(p) for each point.
  template <class Take>
  void visit(const Take& take) const {
    for (const outline_point& p : vertices_) take(p);
    for (const outline_point& p : others_) take(p);
  }

 private:
  std::vector<outline_point> vertices_, others_;
};

}  // namespace asterism::internal::audit_detail
