// SPDX-License-Identifier: MIT
//
// Describes a domain by segments, hole points and region points alone, as a .poly file does, for
// readers that know neither polygons nor the sides of segments.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the domain without its polygons. Adds a hole point to each enclosed face outside of the
// domain that has none. Adds a region point to each part that has none, unless its number is the
// one that parts without a region point have. A domain that its points describe already, as one of
// a .poly file, is returned unchanged. Requires a domain that check_domain accepted. Fails where
// there is no double in a face, and where faces and their segments are so many that it would exceed
// a work limit. Time: O(n log n), and O(n) for each point, for n segments.
result<domain> plain_form(domain accepted);

}  // namespace asterism::internal
