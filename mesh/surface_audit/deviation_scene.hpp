// SPDX-License-Identifier: MIT
//
// Holds the data that both directions of a deviation use.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/data/space_mesh.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/box_tree.hpp"
#include "asterism/mesh/surface_audit/surface_locator.hpp"
#include "asterism/mesh/surface_audit/triangle_distance.hpp"
#include "asterism/mesh/surface_audit/trimmed_places.hpp"

namespace asterism::internal {

// Refers to mesh, surface and indexes of both. All must outlive this object.
struct deviation_scene {
  const space_mesh& mesh;
  const surface& of;
  const std::vector<bezier_piece>& pieces;
  const box_tree& triangles;
  const surface_locator& locator;
  // Place of the surface near the middle of each triangle; null if not known.
  const std::vector<surface_place>* places = nullptr;
  // Regions of trimmed patches; null if no patch is trimmed.
  const trim_scene* trims = nullptr;

  plain_triangle triangle(std::size_t t) const {
    const space_triangle& c = mesh.triangles[t];
    return {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  }
};

// Returns the box of each triangle.
std::vector<space_box> boxes_of_triangles(const space_mesh& mesh);

}  // namespace asterism::internal
