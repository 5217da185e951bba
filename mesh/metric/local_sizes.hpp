// SPDX-License-Identifier: MIT
//
// Makes a metric finer where local sizes are given, and keeps it within bounds.
#pragma once

#include <memory>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"

namespace asterism {

// Returns the size elsewhere if only local sizes are given: the greatest size allowed, or, without
// a bound, the longer side of the domain's box.
ASTERISM_EXPORT double size_where_none_is_wished(const size_wishes& wishes, const domain& d);

// Returns the field with these sizes in the domain `d`, as check_domain leaves it (its curves
// divided: distances are from the chords). Takes ownership of `base`, and returns it unchanged if
// no sizes are given. At each point, in this order:
//
//  - layers: the length across is at most the thickness of the layer there, and the length along
//    the wall at most that which its curvature and its corners allow (metric/wall_layers.hpp);
//  - sizes: no direction is longer than the least of them;
//  - bounds, as `asterism adapt` has them: no direction longer than `greatest`, then none shorter
//    than `least`, which wins, then `aspect`.
//
// A tensor that need not change keeps its bits. Distances are straight, also through walls. Fails
// for a region or a marker that the domain does not have, naming those it has, and for bounds of
// which the least is not below the greatest.
ASTERISM_EXPORT result<std::unique_ptr<metric_field>> with_local_sizes(
    std::unique_ptr<metric_field> base, const domain& d, const size_wishes& wishes);

}  // namespace asterism
