// SPDX-License-Identifier: MIT
//
// Scales a mesh of extreme coordinates or metrics into the range in which bounds in doubles decide.
// The factors are powers of two: the scaling is exact, and no comparison of lengths changes.
#pragma once

#include <optional>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal::audit_detail {

struct unit_subject {
  mesh image;        // coordinates and lengths in the metrics are about 1 at most, or small numbers
  int exponent = 0;  // lengths in the metrics are 2^exponent times those of the image
};

// Returns the scaled image of a mesh; none if the mesh is in that range already, or if a number
// would lose bits. Requires finite coordinates and positive definite metrics.
std::optional<unit_subject> unit_subject_of(const mesh& subject);

// Returns the power of two that brings a positive number to about 1, for numbers that are very
// large or very small; 1 for all others.
double power_of_extreme(double size);
inline double power_to_unit(double size) {
  return 0x1p-100 < size && size < 0x1p100 ? 1 : power_of_extreme(size);
}

}  // namespace asterism::internal::audit_detail
