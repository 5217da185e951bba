// SPDX-License-Identifier: MIT
//
// Decides that a site is too far from a star to matter to a gap of known reach.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// True if w is certainly too far from v to matter to a gap with this reach: for some covector g,
//   g . (w - v) > (|g|_v + max(|g|_v, |g|_w)) reach
// (docs/math/certificate.md, section 4.3). Tries the covector M_v (w - v), and where that suffices
// for equal metrics also the one along which both ellipses together are farthest from w.
bool is_too_far(const site& v, double reach, const site& w);

}  // namespace asterism::internal::audit_detail
