// SPDX-License-Identifier: MIT
//
// Writes Triangle's .poly files.
#pragma once

#include <string>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the contents of a .poly file (mesh/io/poly.hpp) of a domain without curves and polygons,
// numbered from 1: read_poly returns the same vertices, segments, markers, holes and regions.
std::string poly_text(const domain& d);

}  // namespace asterism::internal
