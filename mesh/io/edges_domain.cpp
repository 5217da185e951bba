// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/edges_domain.hpp"

#include <utility>

#include "asterism/mesh/data/site_box.hpp"

namespace asterism::internal {

bool has_edges_alone(const mesh_file& file) {
  return file.content.triangles.empty() && file.content.disagreeing.empty() &&
         !file.content.boundary.empty();
}

domain domain_of_edges(mesh_file file, const std::string& name) {
  domain d;
  d.name = name;
  d.origin.file = d.origin.vertex_file = name;
  d.origin.notes = std::move(file.content.notes);
  d.vertices = positions_of(file.content.sites);
  for (const boundary_edge& e : file.content.boundary) d.segments.push_back({e.a, e.b, e.marker});
  return d;
}

}  // namespace asterism::internal
