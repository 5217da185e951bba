// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/metric_box.hpp"

#include <cmath>
#include <limits>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

bounding_box influence_box(const site& a, const site& b) {
  constexpr double lengths = 1.5;
  bounding_box box = box_of(a.position, b.position);
  for (const site* s : {&a, &b}) {
    const point& other = s == &a ? b.position : a.position;
    box.include(box_around(*s, lengths * std::sqrt(squared_distance(*s, other))));
  }
  return box;
}

// Takes the unit ellipse's extents. With f the metric's quadratic form, the least of f over all
// displacements with the same dx is (m11 - m12^2 / m22) dx^2.
bounding_box box_around(const site& s, double distance) {
  const metric_tensor& m = s.metric;
  const bool thin = is_thin(m);
  const auto half_width = [distance, thin](double own, double mixed, double other) {
    const double least = thin ? least_across(own, mixed, other) : own - mixed * (mixed / other);
    const double width = distance / std::sqrt(least);
    return width >= 0 ? width : std::numeric_limits<double>::infinity();
  };
  const double x = half_width(m.m11, m.m12, m.m22), y = half_width(m.m22, m.m12, m.m11);
  const point& q = s.position;
  return {{q.x - x, q.y - y}, {q.x + x, q.y + y}};
}

}  // namespace asterism::internal
