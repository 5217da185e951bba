// SPDX-License-Identifier: MIT
//
// Refuses distances of a mesh from its surface that doubles cannot prove, and numbers of vertices
// above the limit.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Returns the least distance that can be proved of a mesh of the surface, the greater of two: 2^-52
// times the greatest modulus of its coordinates, since a vertex whose three coordinates are rounded
// to nearest is up to sqrt(3) 2^-53 times that modulus from its place; and the share of the
// surface's extent below which the auditor narrows no bound.
double least_chord(const surface& s);

// Refuses a chord distance below least_chord(s); the message has both distances.
std::optional<error> fault_of_chord(const surface& s, double chord);

// Refuses sizes for which a mesh would exceed the limit on vertices; the message has both numbers.
// `expected` is the number predicted.
std::optional<error> fault_of_count(double expected, std::size_t most, double chord);

}  // namespace asterism::internal
