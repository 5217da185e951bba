// SPDX-License-Identifier: MIT
//
// Refines by the Voronoi-arc heuristic: REFINE of the thesis, section 4.1.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/site_insertion.hpp"

namespace asterism::internal {

// Returns the points where a site may get rid of triangle t: the Voronoi vertices of its three
// sites, nearest first, then the points where their three arcs leave their wedges. At most 4 + 6;
// fewer when t repeats an index.
std::vector<point> arc_candidates(const refine_state& state, const triangle& t);

// Tries the candidates of t in turn until one is inserted; true if one was. Adds to `rejected`
// those that failed.
bool refine_by_arcs(refine_state& state, const triangle& t, double tolerance,
                    std::size_t& rejected);

// Returns the first candidate of t that can simply be inserted: inside, far enough from every site,
// and encroaching on no subsegment. Counts the ones before it in `rejected`.
std::optional<site> find_place(refine_state& state, const triangle& t, double tolerance,
                               std::size_t& rejected);

// Splits a subsegment that hides a candidate of t outside the domain from t, if the candidate is
// near enough to encroach on it from behind; true if one was split. In one metric, if nothing is
// encroached, a candidate is outside by rounding alone: the Voronoi vertex of a right triangle lies
// on the side opposite the right angle, and if that side is slanted the rounded vertex may lie
// beyond it.
bool split_before_candidates(refine_state& state, const triangle& t, double tolerance);

}  // namespace asterism::internal
