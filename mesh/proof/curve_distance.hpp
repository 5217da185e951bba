// SPDX-License-Identifier: MIT
//
// Bounds how far a curve is from chords along it, in rationals. The same theorem as the auditor's
// (docs/math/curves.md), by code of its own.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/data/domain_curve.hpp"
#include "asterism/mesh/proof/number.hpp"

namespace asterism::internal::proof_detail {

// Returns a bound of the distances of the curve and of the polygon through the points from each
// other; nothing where the polygon does not lead along the curve. The first and the last point are
// the curve's ends. Places on cubics are looked for in doubles, which decide nothing.
std::optional<rational> distance_from_chords(const domain_curve& curve,
                                             const std::vector<point>& chords);

}  // namespace asterism::internal::proof_detail
