// SPDX-License-Identifier: MIT
//
// Is what a metric field is besides whose formula can be evaluated over boxes.
#pragma once

#include <optional>

#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

// Encloses the tensors of a field, in exact arithmetic, and their derivatives.
class enclosed_field {
 public:
  virtual ~enclosed_field() = default;
  // Returns them over the points that `at` encloses; nothing where the formula has a part of which
  // nothing is known. In a floating_point_scope(rounding::upward); several threads may ask.
  virtual std::optional<tensor_jet> over(const plane_jet& at) const = 0;
};

}  // namespace asterism::internal
