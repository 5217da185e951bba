// SPDX-License-Identifier: MIT
//
// Repairs a domain that check_domain refuses because its segments cross, nearly meet, or leave
// gaps; changes as little as possible.
//
// Within a distance D, by exact tests on the points as rounded (mesh/domain/snapping.hpp):
//  - points nearer than D become one, the first;
//  - segments that pass a point within D/2 are bent to go through it;
//  - crossings become vertices, rounded once to doubles;
//  - a segment that crosses a boundary, and ends outside or in a hole, is cut off at the boundary;
//  - hole points nearer than D to what then is a segment are dropped.
// Points keep their coordinates unless they are joined to another one; parts farther than D from a
// fault stay unchanged. A segment may move by more than D where several points bend it one after
// the other; the report has the largest move. All of it is counted and listed.
//
// Without a distance given, the first that makes an acceptable domain is taken of 2^-40, 2^-36, ...
// 2^-12 times the longer side of the box: a gap is closed by the least that closes it. At 2^-40 a
// triangle between neighbouring points has 12 bits of a double for its shape. Wider gaps than 2^-12
// may be intended. No distance is below 8 units in the last place of a coordinate.
//
// Not repaired: a ring within a ring without a hole point divides the domain, as in other domains;
// the part of a hole that sticks out of the boundary becomes a part of the domain. Refused as by
// check_domain, and where the segments fall into more than four million pieces.
#pragma once

#include <optional>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// Returns a domain that check_domain accepts without a repair, or refuses the input. `distance`, if
// given, is D: positive, finite. `repairs`, when given, is overwritten. Fails when `stop` is
// requested; its account is charged with the work, which is quadratic in the crossings at worst.
ASTERISM_EXPORT result<domain> repair_domain(const domain& input,
                                             std::optional<double> distance = {},
                                             domain_repairs* repairs = nullptr,
                                             const cancellation& stop = {});

}  // namespace asterism
