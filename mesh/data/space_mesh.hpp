// SPDX-License-Identifier: MIT
//
// Holds a triangle mesh in space as plain data.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

using space_triangle = std::array<std::uint32_t, 3>;

// A mesh in space. `faces` has the number of the surface's face for each triangle, or is empty.
struct space_mesh {
  std::vector<space_point> points;
  std::vector<space_triangle> triangles;
  std::vector<std::uint32_t> faces = {};
  // Notes on what its reader changed or left out, a sentence each.
  std::vector<std::string> notes = {};
};

}  // namespace asterism::internal
