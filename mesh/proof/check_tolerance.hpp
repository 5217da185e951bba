// SPDX-License-Identifier: MIT
//
// Decides whether the tensors in which a mesh is proved differ from those asked for by a tolerance
// or less.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns, as an error, the first vertex whose tensor in `delivered` measures some length more than
// exp(tolerance) times as long, or as short, as its tensor in `wanted`; nothing if there is none.
// Decided in rationals, with a rational lower bound in place of exp(tolerance)^2. Tensors must be
// definite and `tolerance` not negative.
std::optional<error> check_tolerance(const mesh& delivered, const mesh& wanted, double tolerance);

}  // namespace asterism::internal
