// SPDX-License-Identifier: MIT
//
// Reads gmsh's .msh as a mesh in space: its triangles, by the reader of plane meshes.
#include "asterism/mesh/surface_io/space_gmsh.hpp"

#include <utility>

#include "asterism/mesh/io/listed_readers.hpp"

namespace asterism::internal {

// Refuses elements whose surface their corners do not determine: sides of second order, four
// corners that need not be in a plane.
result<space_mesh> parse_space_gmsh(std::string_view text, const std::string& file) {
  text_scanner from(file, text);
  auto read = read_gmsh_as_listed(from);
  if (!read) return read.failure();
  const listed_mesh& listed = read.value();
  if (listed.second_order > 0)
    return error{file +
                 ": elements of higher order: in space, triangles of first order can be read"};
  if (!listed.quadrilaterals.empty())
    return from.failure(listed.quadrilaterals.front().line,
                        "a quadrilateral: in space, triangles can be read");
  space_mesh made;
  made.points.reserve(listed.content.sites.size());
  for (const site& s : listed.content.sites) made.points.push_back({s.position.x, s.position.y, 0});
  for (const listed_height& h : listed.heights) made.points[h.vertex].z = h.z;
  made.triangles.assign(listed.content.triangles.begin(), listed.content.triangles.end());
  return made;
}

}  // namespace asterism::internal
