// SPDX-License-Identifier: MIT
//
// Bounds the distance of a curve from the chords along it, in rationals: by the theorem that the
// auditor uses (docs/math/curves.md), in independent code.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/data/domain_curve.hpp"
#include "asterism/mesh/proof/number.hpp"

namespace asterism::internal::proof_detail {

// Returns a bound of the distance between the curve and the polygon through the points, in both
// directions; nothing if the polygon does not lead along the curve. The first and the last point
// are the curve's ends. Places on cubics are searched in doubles, which affect the size of the
// bound, not its validity.
std::optional<rational> distance_from_chords(const domain_curve& curve,
                                             const std::vector<point>& chords);

}  // namespace asterism::internal::proof_detail
