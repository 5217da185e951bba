// SPDX-License-Identifier: MIT
//
// Says a domain by segments, hole points and region points alone, as a .poly file has them: whoever
// reads that needs to know nothing of polygons, or of which side of a segment is which.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the domain without its polygons, and with a hole point in each face that is enclosed,
// outside and has none, and a region point in each part that has none and a number other than such
// parts have. A domain that its points say already, as one of a .poly file is, is returned as it
// is. Requires what check_domain accepted. Fails where there is no double in a face, and where so
// many faces have so many segments around them that it would not end. Time: O(n log n), and O(n)
// for each point, for n segments.
result<domain> plain_form(domain accepted);

}  // namespace asterism::internal
