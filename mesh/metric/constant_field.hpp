// SPDX-License-Identifier: MIT
//
// Makes fields that are the same tensor everywhere, and means of tensors.
#pragma once

#include <memory>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Returns a field that fails where the tensor is no metric.
std::unique_ptr<metric_field> same_everywhere(const metric_tensor& m);

// Returns the log-Euclidean mean of one tensor or more. Requirements on tensors are those of
// numerics/metric_algebra.hpp.
metric_tensor mean_of(const std::vector<metric_tensor>& tensors);

}  // namespace asterism::internal
