// SPDX-License-Identifier: MIT
//
// Enumerates the conditions that remain for the stars of a mesh: pairs of a gap and a site so near
// to it that the proof must show that the gap refuses the site.
//
// A site that a gap accepts is within the radius, in its own metric, of a point of the gap's region
// (docs/math/proof-format.md, lemma 4). So the triangles that the ball of a site meets contain, or
// list, every gap that might accept it. The triangles around the mesh are traversed, too, so that
// the search crosses the boundary.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/gap_row.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

// True if a witness is needed for the edge: it is inside the mesh, no segment, the diagonal of a
// convex quadrilateral, and has the lesser of its two numbers.
bool is_edge_asked(const plane& all, std::uint32_t edge);
// Returns v, w, x and y of an inner edge.
edge_sites sites_of_edge(const plane& all, std::uint32_t edge);

// True if the gap needs a row: the edge opposite its vertex is no segment.
inline bool is_gap_asked(const plane& all, std::uint32_t gap) {
  return !all.is_segment[plane::next(gap)];
}
// True if all sites have one metric: then no gap needs a row (theorem 5).
bool has_one_metric(const mesh& subject);

gap_sites sites_of_gap(const plane& all, std::uint32_t gap);

// Returns whether the gap is shown to refuse the site, for pairs that the gap's own row does not
// decide.
using pair_question = std::function<bool(std::uint32_t gap, vertex_index w)>;

// Decides for every site and each gap near it that the gap refuses it. Returns the first pair that
// is not decided, as an error; `ask` is called from many threads.
std::optional<error> check_pairs(const plane& all, const gap_rows& gaps, double squared_radius,
                                 const pair_question& ask);

}  // namespace asterism::internal::proof_detail
