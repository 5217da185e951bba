// SPDX-License-Identifier: MIT
//
// Goes through the questions that are left of the stars of a mesh: which sites are near enough to a
// gap that its point must show them to be refused.
//
// A site that a gap accepts is within the radius, as it measures, of a point of the gap's region
// (docs/math/proof-format.md, lemma 4). So a walk from each site over the triangles that its ball
// meets comes to all gaps that it is to be held against. The triangles around the mesh are walked
// over, too: nothing is missed behind the boundary.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/gap_row.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

// True if the edge is one inside the mesh about which its ends are to be asked: no segment, the
// lesser of its two numbers, and the diagonal of a quadrilateral that is convex.
bool is_edge_asked(const plane& all, std::uint32_t edge);
// Returns v, w, x and y of an inner edge.
edge_sites sites_of_edge(const plane& all, std::uint32_t edge);

// True if anything is seen beyond the gap: the edge across from it is no segment.
inline bool is_gap_asked(const plane& all, std::uint32_t gap) {
  return !all.is_segment[plane::next(gap)];
}
// True if all sites have one metric: then no gap is asked about (theorem 5).
bool has_one_metric(const mesh& subject);

gap_sites sites_of_gap(const plane& all, std::uint32_t gap);

// Is asked about a gap and a site that the gap's own row does not settle.
using pair_question = std::function<bool(std::uint32_t gap, vertex_index w)>;

// Holds every site against all gaps that it comes near. Returns what is not settled; `ask` is
// called from many threads.
std::optional<error> check_pairs(const plane& all, const gap_rows& gaps, double squared_radius,
                                 const pair_question& ask);

}  // namespace asterism::internal::proof_detail
