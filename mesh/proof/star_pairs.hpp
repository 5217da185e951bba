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
#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/star_conditions.hpp"

namespace asterism::internal::proof_detail {

// The witnesses of all gaps by number, zeros where none is asked for.
using gap_witnesses = std::vector<proof_gap>;

inline grid_point as_grid_point(const proof_point& p) { return {p[0], p[1]}; }
inline std::array<grid_point, 3> points_of(const proof_gap& gap) {
  return {grid_point{gap.on_x, 0}, as_grid_point(gap.between), grid_point{0, gap.on_y}};
}

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

// True if the witness is a sound one.
bool is_gap_sound(const plane& all, std::uint32_t gap, const proof_gap& witness);
// True if all that it spans is within the radius.
bool is_gap_within(const plane& all, std::uint32_t gap, const proof_gap& witness,
                   double squared_radius);
// Returns an upper bound of the square of the radius that the gap asks for.
double squared_reach(const plane& all, std::uint32_t gap, const proof_gap& witness);

// Is asked about a gap and a site that the gap's own point does not settle.
using pair_question = std::function<bool(std::uint32_t gap, vertex_index w)>;

// Holds every site against all gaps that it comes near. Returns what is not settled; `ask` is
// called from many threads.
std::optional<error> check_pairs(const plane& all, const gap_witnesses& gaps, double squared_radius,
                                 const pair_question& ask);

// True if the fan of points shows that the gap from x to y of v refuses w.
bool is_refused_by(const site& v, const site& x, const site& y, const site& w,
                   const std::vector<proof_point>& points, std::size_t turn);

}  // namespace asterism::internal::proof_detail
