// SPDX-License-Identifier: MIT
//
// Makes fields given by an edge length across a layer, one along it, and the direction across:
// boundary layers, shocks, and the benchmarks of the Unstructured Grid Adaptation Working Group.
// Formulas and sources are in docs/manual/metrics.md.
#pragma once

#include <span>

#include "asterism/mesh/metric/named_field.hpp"

namespace asterism::internal {

// Returns the rows of these fields: `layer`, `shock` and the benchmarks.
std::span<const named_field> layered_fields();

}  // namespace asterism::internal
