// SPDX-License-Identifier: MIT
//
// Writes points and metric tensors in messages.
#pragma once

#include <string>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Returns "(x, y)", with six significant digits each.
std::string point_text(const point& q);

// Returns "m11 m12 m22" with six significant digits each; with as many as the doubles need where
// the tensor is not positive definite, and the one of the rounded entries is.
std::string tensor_text(const metric_tensor& m);

}  // namespace asterism::internal
