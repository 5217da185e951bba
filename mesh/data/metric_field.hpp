// SPDX-License-Identifier: MIT
//
// Defines the metric field: the metric tensor wanted at each point of the domain.
#pragma once

#include <functional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// A field of wanted tensors. `at` is deterministic and thread-safe. It fails, naming the point and
// the three numbers, where the tensor is not finite or not (exactly tested) positive definite.
class ASTERISM_EXPORT metric_field {
 public:
  virtual ~metric_field() = default;
  virtual result<metric_tensor> at(const point& q) const = 0;
  // Announces that `at` will be called for these places, or most of them, and perhaps for others. A
  // field for which many evaluations at once are cheaper calls `places` and stores the results;
  // other fields ignore it. Changes no result of `at`.
  virtual void expect(const std::function<std::vector<point>()>& places) const { (void)places; }
  // Returns the mesh at whose vertices the field is given, with these tensors; null for other
  // fields. It lives as long as the field.
  virtual const mesh* background() const { return nullptr; }
};

}  // namespace asterism
