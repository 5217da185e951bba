// SPDX-License-Identifier: MIT
//
// Brings a solution from the vertices of one mesh to those of another one of the same domain.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism {

// interpolate: the value of the old field at the new vertex. Linear fields to rounding; no new
// extrema;
//              integrals change.
// project:     the nearest field in the mean square, over the common parts of old and new
// triangles.
//              Integrals and linear fields to rounding; may overshoot.
// bounded:     the projection with as much diffusion as it takes to stay, at each vertex, within
// the old
//              values around it. Integrals to rounding; no new extrema.
enum class transfer_method { interpolate, project, bounded };

// One component of the solution before and after.
struct transferred_component {
  std::string name;
  double integral_before = 0, integral_after = 0;
  double least_before = 0, greatest_before = 0, least_after = 0, greatest_after = 0;
};

// Report of what was done.
struct transfer_report {
  std::vector<transferred_component> components;
  double area_before = 0, area_after = 0;
  double area_common = 0;          // 0 for interpolate, which does not ask
  std::size_t outside = 0;         // new vertices outside the old mesh, by exact orientations
  double greatest_distance = 0;    // of those from it
  std::size_t partly_covered = 0;  // new triangles with more than 1e-6 of them outside the old mesh
  std::size_t pieces = 0;          // common parts
};

// The solution at the new vertices.
struct transferred_solution {
  solution values;
  transfer_report report;
};

// Transfers all fields, tensors entry by entry. Requires triangulations of domains that differ by
// little: new triangles that are partly outside the old mesh take the interpolated values, and
// count. Nothing is read across a gap: a vertex outside gets its value from the triangles joined to
// those of its neighbours. Fails where a part of the new mesh does not touch the old one, for a
// solution that is not on `from`, and where an area or an integral is beyond all doubles. Scaled by
// powers of two, places or values, the outcome is the same, scaled. Time and memory are linear in
// the triangles and their common parts; parallel, the same for any number of threads.
ASTERISM_EXPORT result<transferred_solution> transfer_solution(const mesh& from,
                                                               const solution& values,
                                                               const mesh& to, transfer_method how);

}  // namespace asterism
