// SPDX-License-Identifier: MIT
//
// Tells whether two domains are one. Internal to the auditor.
#pragma once

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// True if two domains, both as check_domain leaves them, are the same in all that a certificate
// holds of one: vertices and segments in their order with markers, sides and regions, and curves.
bool is_same_domain(const domain& c, const domain& d);

}  // namespace asterism::internal
