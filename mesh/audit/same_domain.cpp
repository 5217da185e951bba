// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/same_domain.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

bool is_same_segment(const segment& s, const segment& t) {
  return s.a == t.a && s.b == t.b && s.marker == t.marker && s.internal == t.internal &&
         s.left_region == t.left_region && (!s.internal || s.right_region == t.right_region);
}

bool is_same_curve(const domain_curve& c, const domain_curve& d) {
  const bool is_same_shape = c.kind == curve_kind::arc
                                 ? c.centre == d.centre && c.clockwise == d.clockwise
                                 : c.control == d.control;
  return c.kind == d.kind && is_same_shape && c.vertices == d.vertices &&
         c.parameters == d.parameters;
}

}  // namespace

bool is_same_domain(const domain& c, const domain& d) {
  return c.vertices == d.vertices &&
         std::equal(c.segments.begin(), c.segments.end(), d.segments.begin(), d.segments.end(),
                    is_same_segment) &&
         std::equal(c.curves.begin(), c.curves.end(), d.curves.begin(), d.curves.end(),
                    is_same_curve);
}

}  // namespace asterism::internal
