// SPDX-License-Identifier: MIT
//
// Decides in doubles whether a site encroaches on a subsegment, where they can tell
// (predicates/encroachment.hpp has the question, and the kernel the rest).
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

// Returns whether w encroaches on the subsegment a b, or "unknown". Requires finite numbers,
// positive definite metrics and three distinct sites.
uncertain_bool encroaches_quickly(const site& a, const site& b, const site& w);

}  // namespace asterism::internal
