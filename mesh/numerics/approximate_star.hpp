// SPDX-License-Identifier: MIT
//
// Approximates stars in plain doubles, without the boundary, to find where there is room for a
// site.
//
// Exact tests on the points as rounded decide everything that follows: approximate stars only
// propose where sites may go. They are many times cheaper than true stars, and a wrong neighbour
// costs at most one useless proposal.
//
// The star of v is read off a convex hull: with d = w - v the effect of the site w on v's
// territory is given, approximately, by the covector z = M_w d / |d|_w^2 (the first point in
// direction u at which w is as near as v is u / s with s = 2 z.u to first order in M_w - M_v), and
// the neighbours are the corners of the hull of all z. Source: docs/math/certificate.md, section
// 4.1.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// The gap from one neighbour counter-clockwise to the next one.
struct approximate_gap {
  vertex_index neighbour = 0;
  // The Voronoi vertex of the centre and both neighbours, relative to the centre, and its squared
  // distance, as the centre measures; infinite when none was found.
  point vertex;
  double squared_radius = 0;
};

using approximate_star = boost::container::small_vector<approximate_gap, 8>;

// Returns the number of the gap after gap i.
inline std::size_t following(const approximate_star& star, std::size_t i) {
  return i + 1 < star.size() ? i + 1 : 0;
}

// Sets the vertex of a gap that is known from another star, given the site after the gap; returns
// false if it is not known.
using known_vertex = std::function<bool(approximate_gap& gap, vertex_index next)>;

// Returns the star of v among the candidates; v itself and repetitions are skipped. `before` may be
// an earlier star of v whose neighbours are the first candidates, in its order: gaps that are in
// both are copied. `known`, where given, is called before a vertex is computed.
approximate_star build_approximate_star(const std::vector<site>& sites, vertex_index v,
                                        const std::vector<vertex_index>& candidates,
                                        const approximate_star& before = {},
                                        const known_vertex& known = {});

// Returns the star of v among the candidates as build_approximate_star does, but with fewer errors,
// at several times the cost: where the hull does not decide clearly whether a candidate is a
// neighbour, the Voronoi vertex of the candidates beside it decides, which is the same in all
// stars; and of sites on one ray only the nearest is taken.
approximate_star build_careful_star(const std::vector<site>& sites, vertex_index v,
                                    const std::vector<vertex_index>& candidates);

// Sets the vertex of a gap of v's star between gap.neighbour and `next` to `found`, which the star
// of w, one of these two, has. Returns false where that is not known, or is no vertex of v's gap.
bool take_vertex(const std::vector<site>& sites, vertex_index v, approximate_gap& gap,
                 vertex_index next, vertex_index w, const approximate_gap& found);

// Computes the vertex of a gap of v's star between gap.neighbour and `next`.
void close_gap(const std::vector<site>& sites, vertex_index v, approximate_gap& gap,
               vertex_index next);

// True if the gap of v's star between gap.neighbour and `next` is less than half a turn and has no
// vertex: where metrics vary fast, farther sites seldom give it one.
bool lacks_vertex(const std::vector<site>& sites, vertex_index v, const approximate_gap& gap,
                  vertex_index next);

// True if each neighbour is one without doubt: the Voronoi vertices to both sides of it are known,
// and v sees the edge between them at an angle far above rounding errors.
bool is_plainly_a_star(const std::vector<site>& sites, vertex_index v,
                       const approximate_star& star);

// True if w, which is not in the star of v, would change it.
bool disturbs(const std::vector<site>& sites, vertex_index v, const approximate_star& star,
              vertex_index w);

}  // namespace asterism::internal
