// SPDX-License-Identifier: MIT
//
// The metric tensor wanted at each point of the domain.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"

namespace asterism {

// A function from points to metric tensors. Derive from it for a field of your own; `at` must be
// deterministic and safe to call from several threads at once. It fails, naming the point and the
// three numbers, where the tensor is not finite or not (exactly tested) positive definite.
class metric_field {
 public:
  virtual ~metric_field() = default;
  virtual result<metric_tensor> at(const point& q) const = 0;
};

}  // namespace asterism
