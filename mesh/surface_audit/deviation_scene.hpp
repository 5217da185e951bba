// SPDX-License-Identifier: MIT
//
// Holds what both directions of a deviation look at.
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

// Refers to what both directions look at. All must outlive it.
struct deviation_scene {
  const space_mesh& mesh;
  const surface& of;
  const std::vector<bezier_piece>& pieces;
  const box_tree& triangles;
  const surface_locator& locator;
  // A place of the surface near the middle of each triangle; null: not known.
  const std::vector<surface_place>* places = nullptr;
  // The regions of trimmed patches; null: no patch is trimmed.
  const trim_scene* trims = nullptr;

  plain_triangle triangle(std::size_t t) const {
    const space_triangle& c = mesh.triangles[t];
    return {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  }
};

// Returns the box of each triangle.
std::vector<space_box> boxes_of_triangles(const space_mesh& mesh);

}  // namespace asterism::internal
