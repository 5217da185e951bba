// SPDX-License-Identifier: MIT
//
// Decides whether the tensors in which a mesh is proved are near enough to those asked for.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns which vertex has a tensor in `delivered` that finds some length more than exp(tolerance)
// times as long, or as short, as its tensor in `wanted` does; nothing if none has. Decided in
// rationals, of which one stands for exp(tolerance)^2 from below. Tensors must be definite and
// `tolerance` not negative.
std::optional<error> check_tolerance(const mesh& delivered, const mesh& wanted, double tolerance);

}  // namespace asterism::internal
