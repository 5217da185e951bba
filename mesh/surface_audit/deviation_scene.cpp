// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/deviation_scene.hpp"

namespace asterism::internal {

std::vector<space_box> boxes_of_triangles(const space_mesh& mesh) {
  std::vector<space_box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const space_triangle& t : mesh.triangles) {
    space_box box = space_box::of(mesh.points[t[0]]);
    box.include(mesh.points[t[1]]);
    box.include(mesh.points[t[2]]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace asterism::internal
