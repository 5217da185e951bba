// SPDX-License-Identifier: MIT
//
// Bounds how fast a metric varies over a small part of the plane, from enclosures of its tensors.
// Source: docs/math/guarantee.md, "The field's sigma".
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"
#include "asterism/mesh/metric/layer_enclosure.hpp"

namespace asterism::internal {

// Number of directions in which variation is bounded: half the vertices of a regular polygon around
// the unit circle, as opposite vertices have one value. The slack bounds the distance of the
// vertices from the centre: 1 / cos(pi / 32) = 1.004838..., and 1e-5 more for their coordinates in
// doubles.
inline constexpr int variation_directions = 16;
inline constexpr double direction_slack = 1.00485;

// A part of the plane: one of its points, and the greatest distances of others from it along x and
// y.
struct small_part {
  point middle;
  double reach_x = 0, reach_y = 0;
};

// Upper bound of the variation in a part, and an approximate value in its middle.
struct variation_of_part {
  double above = 0, in_middle = 0;
};

// Returns bounds from the tensors over a part and in its middle; `above` is infinite where the part
// is too large for them. Requires a floating_point_scope(rounding::upward).
variation_of_part bound_variation_of(const small_part& part, const tensor_jet& over,
                                     const tensor_jet& in_middle);

// Returns an upper bound of the variation of layers, from their frame; infinite where there is
// none.
double bound_variation_of(const layer_enclosure& layers);

}  // namespace asterism::internal
