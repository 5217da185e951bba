// SPDX-License-Identifier: MIT
//
// Decides in doubles whether a site encroaches on a subsegment, where error bounds allow it
// (predicates/encroachment.hpp defines the question; the kernel decides the rest).
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

// Returns whether w encroaches on the subsegment a b, or "unknown". Requires finite numbers,
// positive definite metrics and three distinct sites.
uncertain_bool encroaches_quickly(const site& a, const site& b, const site& w);

}  // namespace asterism::internal
