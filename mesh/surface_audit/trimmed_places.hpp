// SPDX-License-Identifier: MIT
//
// Finds places inside of trimmed patches with which points of a mesh are compared.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_audit/surface_locator.hpp"
#include "asterism/mesh/surface_audit/triangle_net.hpp"
#include "asterism/mesh/surface_audit/trim_region.hpp"

namespace asterism::internal {

// Data of a surface with trimmed patches, and of a mesh made of it.
struct trim_scene {
  std::vector<trim_region> regions;  // by patch
  std::vector<patch_spans> spans;    // by patch
  // Origin of each triangle of the mesh: the patch and the triangle of its parameters that it was
  // lifted from, all of which is in the region.
  struct origin {
    std::uint32_t patch = 0;
    std::array<parameter_point, 3> at{};
  };
  std::vector<origin> origins;
};

// A triangle of parameters in one piece, all of which belongs to the surface.
struct held_triangle {
  std::uint32_t piece = 0;
  parameter_triangle corners;
};

// All of these functions require a floating_point_scope(rounding::upward).

// True if the triangle of three places of one piece certainly belongs to the surface.
bool is_on_surface(const std::vector<bezier_piece>& pieces, const trim_scene& trims,
                   const std::array<surface_place, 3>& at);

// Returns places of the surface for the corners of a part of a triangle, within the triangle of
// parameters from which the part was lifted: all places are of one piece, and near the places
// nearest to the corners. `corners` and `whole` are in space. If no three places are in one piece,
// returns one place three times. None if no place is certain.
std::optional<held_triangle> places_in_origin(const std::vector<bezier_piece>& pieces,
                                              const trim_scene& trims,
                                              const trim_scene::origin& origin,
                                              const std::array<plain_vector, 3>& whole,
                                              const std::array<plain_vector, 3>& corners);

}  // namespace asterism::internal
