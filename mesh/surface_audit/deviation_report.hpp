// SPDX-License-Identifier: MIT
//
// Holds bounds of the distance between a mesh and a surface, upper and lower ones.
#pragma once

#include <cstddef>

#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// A point of the mesh: corner weights 1 - s - t, s and t in a triangle; or of the surface: the
// patch and its parameters. Indices from 0.
struct deviation_witness {
  bool on_mesh = true;
  std::size_t of = 0;  // triangle or patch
  double first = 0, second = 0;
  space_point at;  // rounded
};

// Bounds in one direction. The witness is proved to have at least the distance `low`; 0 needs no
// witness.
struct one_sided_distance {
  double low = 0, high = 0;
  deviation_witness witness;
  bool narrowed = false;  // as far as asked for
  std::size_t cells = 0;
};

struct deviation_report {
  one_sided_distance from_mesh;     // the greatest distance of a point of the mesh from the surface
  one_sided_distance from_surface;  // and of a point of the surface from the mesh
};

}  // namespace asterism::internal
