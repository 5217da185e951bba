// SPDX-License-Identifier: MIT
//
// Finds shapes at the nodes of a background that are noise, and replaces them by those around.
//
// A Hessian recovered from values with noise turns and stretches at random where it is small. The
// shape of a tensor is the part of its logarithm without a trace: which way it is long, and how
// much. A node's shape is replaced by that neighbour's which is nearest to those of the others, if
// it is farther from that one than they are, and if the metric is nowhere much less dense than
// around: a feature that the background barely resolves is denser than what is beside it, and keeps
// its shape. Densities stay, so that as many sites are wanted as before.
//
// In doubles: a mesh is made in the outcome, and the metric wanted is what it was.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

// Returns the field's tensors, with shapes that are noise replaced by those around, and all others
// the same to the last bit. Charges the account of `stop`.
std::vector<metric_tensor> without_noise(const background_metric& field,
                                         const cancellation& stop = {});

}  // namespace asterism::internal::adapting
