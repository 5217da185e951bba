// SPDX-License-Identifier: MIT
//
// Decides edge_test by its filters alone. Exact numbers, which may have to follow, take a hundred
// times as long: a caller that can avoid a hard question tries the filters first.
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism::internal {

// Returns what filtered_kernel::edge_test(v, w, x, y) would where it needs no exact arithmetic, or
// only on short numbers as the four metrics are equal; undecided otherwise. Counts in `decided` the
// last tier that was tried.
uncertain_bool filtered_edge_test(const site& v, const site& w, const site& x, const site& y,
                                  tier_counters& decided);

}  // namespace asterism::internal
