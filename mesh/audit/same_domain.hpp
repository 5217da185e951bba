// SPDX-License-Identifier: MIT
//
// Decides whether two domains are equal. Internal to the auditor.
#pragma once

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// True if two domains, both as check_domain leaves them, agree in all that a certificate states of
// a domain: vertices and segments in order with markers, sides and regions, and curves.
bool is_same_domain(const domain& c, const domain& d);

}  // namespace asterism::internal
