// SPDX-License-Identifier: MIT
//
// The Voronoi-arc heuristic: REFINE of the thesis, section 4.1.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/site_insertion.hpp"

namespace asterism::internal {

// Where a site may go to get rid of triangle t: the Voronoi vertices of its three sites, nearest
// first, then the points where their three arcs leave their wedges. At most 4 + 6; fewer when t
// repeats an index.
std::vector<point> arc_candidates(const refine_state& state, const triangle& t);

// Tries the candidates of t in turn. Adds to `rejected` those that failed.
bool refine_by_arcs(refine_state& state, const triangle& t, double tolerance,
                    std::size_t& rejected);

// The first candidate of t that can simply be inserted: inside, far enough from every site, and
// encroaching on nothing. Adds to `rejected` those before it.
std::optional<site> find_place(refine_state& state, const triangle& t, double tolerance,
                               std::size_t& rejected);

}  // namespace asterism::internal
