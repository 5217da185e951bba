// SPDX-License-Identifier: MIT
//
// Makes fields given by an edge length across a layer, one along it, and the direction across:
// boundary layers, shocks, and the benchmarks of the Unstructured Grid Adaptation Working Group.
// The formulas and their sources are in docs/manual/metrics.md.
#pragma once

#include <optional>
#include <string_view>

#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism::internal {

// Makes the field of one of the specifications `layer[:H0,H1]`, `shock[:A]`, `linear`, `polar-1`,
// `polar-2`, `circle-1`; empty when `name` is none of them. `specification` is the whole, for
// messages.
std::optional<made_field> make_layered_field(std::string_view specification, std::string_view name,
                                             std::optional<std::string_view> parameter,
                                             const bounding_box& box, double size);

}  // namespace asterism::internal
