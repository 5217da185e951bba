// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/outline.hpp"

namespace asterism::internal {

mesh outline_of(const domain& d) {
  mesh shown;
  shown.sites.reserve(d.vertices.size());
  for (const point& p : d.vertices) shown.sites.push_back({p, {1, 0, 1}});
  shown.given = static_cast<vertex_index>(d.vertices.size());
  for (std::size_t i = 0; i < d.segments.size(); ++i) {
    const segment& s = d.segments[i];
    if (s.a < d.vertices.size() && s.b < d.vertices.size())
      shown.boundary.push_back({s.a, s.b, static_cast<vertex_index>(i), s.marker, s.internal});
  }
  return shown;
}

}  // namespace asterism::internal
