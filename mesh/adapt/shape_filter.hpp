// SPDX-License-Identifier: MIT
//
// Finds shapes at the nodes of a background that are noise, and replaces them by neighbours'
// shapes.
//
// A Hessian recovered from values with noise turns and stretches at random where it is small. The
// shape of a tensor is the trace-free part of its logarithm: the direction and the ratio of its
// stretching. Among the neighbours' shapes, the one nearest to the others is their middle. It
// replaces the node's shape if most neighbours' shapes are nearer to it than the node's is, and if
// the neighbours are as dense as the node: a feature that the background barely resolves is denser
// than its surroundings, and keeps its shape. Densities stay, so that the number of sites wanted
// does not change.
//
// Works in doubles: a mesh is made in the filtered metric, and the metric wanted stays unchanged.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

// Returns the field's tensors, with shapes that are noise replaced by neighbours' shapes, and all
// others unchanged to the last bit. Charges the account of `stop`.
std::vector<metric_tensor> without_noise(const background_metric& field,
                                         const cancellation& stop = {});

}  // namespace asterism::internal::adapting
