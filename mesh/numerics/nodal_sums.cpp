// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/nodal_sums.hpp"

namespace asterism::internal {

double doubled_area(const mesh& m, const triangle& t) {
  const point &a = m.sites[t[0]].position, &b = m.sites[t[1]].position, &c = m.sites[t[2]].position;
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<double> nodal_areas(const mesh& m, const mesh_links& links) {
  std::vector<double> areas(m.sites.size(), 0.0);
  for_each_node(areas.size(), [&](std::size_t v) {
    for (const incidence& at : links.around(static_cast<vertex_index>(v)))
      areas[v] += doubled_area(m, m.triangles[at.triangle]) / 6;
  });
  return areas;
}

}  // namespace asterism::internal
