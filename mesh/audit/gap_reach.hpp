// SPDX-License-Identifier: MIT
//
// Bounds how far from v sites matter to one gap of its star, in few operations: most gaps are never
// asked about any site, and need no more.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// Returns R of lemma 4.3 (docs/math/certificate.md) for the gap of v's star from x
// counter-clockwise to y, in v's metric, with the lower bounds of 4.2; infinite where plain doubles
// do not know one. Requires distinct sites with positive definite metrics.
double quick_reach(const site& v, const site& x, const site& y);

}  // namespace asterism::internal::audit_detail
