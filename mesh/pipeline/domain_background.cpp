// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/domain_background.hpp"

namespace asterism::internal {
namespace {

double cross(const point& origin, const point& a, const point& b) {
  return (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
}

double area_of(const mesh& m) {
  double doubled = 0;
  for (const triangle& t : m.triangles)
    doubled += cross(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position);
  return doubled / 2;
}

// The domain is on the left of its boundary.
double area_of(const domain& d) {
  double doubled = 0;
  for (const segment& s : d.segments)
    if (!s.internal) doubled += cross(d.vertices.front(), d.vertices[s.a], d.vertices[s.b]);
  return doubled / 2;
}

}  // namespace

const mesh* background_of_domain(const domain& d, const metric_field& field) {
  constexpr double most = 1.01;
  const mesh* const given = field.background();
  return given != nullptr && area_of(*given) <= most * area_of(d) ? given : nullptr;
}

}  // namespace asterism::internal
