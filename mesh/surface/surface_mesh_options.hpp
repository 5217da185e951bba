// SPDX-License-Identifier: MIT
//
// Holds the options of the mesh of a surface.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

struct surface_mesh_options {
  double chord = 0;                     // the greatest distance, both ways
  std::optional<double> normal;         // degrees that the normal may turn along an edge
  std::optional<double> longest;        // edge
  double aspect = 100;                  // the greatest ratio of lengths wanted
  std::optional<std::size_t> vertices;  // about; the chord then decides nothing but the verdict
  double angle_bound = 20;              // degrees, of the plane meshes
  // True to keep the angle bound even if faces do not come to agree how to divide a common side
  // with it; else the faces' later meshes drop it.
  bool keeps_angle_bound = false;
  std::size_t most_rounds = 40;
  std::size_t most_sites = 1'000'000;  // of a patch
  cancellation stop = {};
};

}  // namespace asterism::internal
