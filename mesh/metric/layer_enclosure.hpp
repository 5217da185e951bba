// SPDX-License-Identifier: MIT
//
// Encloses a metric of layers over a box in its own frame: lengths across and along a direction,
// which turns from place to place. Unlike entries of tensors these do not cancel where layers are
// thin. Source: docs/math/guarantee.md, "The field's sigma". In a
// floating_point_scope(rounding::upward).
#pragma once

#include <optional>

#include "asterism/core/rounded_interval.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

// Holds enclosures over a box, in the coordinates of the domain. The normal n is the direction
// across, the tangent t its left turn; A and B are the lengths across and along that the metric
// measures as 1.
struct layer_enclosure {
  rounded_interval across, along;
  rounded_interval across_by_normal, across_by_tangent;  // the derivatives of A along n and t
  rounded_interval along_by_normal, along_by_tangent;    // those of B
  // The derivatives along n and t of the normal's angle, in radians, times B/A - A/B.
  rounded_interval turn_by_normal, turn_by_tangent;
};

class layered {
 public:
  virtual ~layered() = default;
  // Returns the enclosures over a box; nothing where none are known.
  virtual std::optional<layer_enclosure> layers_over(const plane_jet& at) const = 0;
};

}  // namespace asterism::internal
