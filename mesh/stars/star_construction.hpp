// SPDX-License-Identifier: MIT
//
// Constructs the star of one site from all the others (CONSTRUCTSTAR of the thesis).
//
// The thesis looks at every site once, in any order. Where Voronoi arcs are not wedged the result
// then depends on the order, and coarse stars keep neighbours they should not. Here sites are
// offered from near to far (as v measures; ties by position), repeatedly until the star is
// *settled*:
//   (a) every neighbour that is not forced passes its own test against the star without it,
//   (b) no other site that v sees is accepted.
// Both hold for the finished star, not only at some earlier moment. A site that the present star
// has refused is not offered to it again, so a star that settles costs little more than one
// round.
//
// With a neighbourhood only the sites near v are looked at, in two steps. First, the sites within
// about twice the distance of the farthest Voronoi vertex make the star. If plain doubles guess
// that star right (numerics/approximate_star.hpp), it is only confirmed (stars/star_finality.hpp),
// against all sites if possible. Then a thorough search offers every other site that is not
// certainly out of reach (site_index.hpp).
#pragma once

#include <optional>
#include <span>

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

struct constructed_star {
  star content;
  // True if the star is settled. False (the default) when neighbours were still replacing each
  // other after the bound on rounds (stars/star_construction.cpp); (a) or (b) of the definition
  // above then fails.
  bool settled = false;
  // True if a thorough search had to change the star made of the near sites; false by default.
  bool repaired = false;
  // Reach of a star known to be final (stars/star_finality.hpp): a site that comes later and is
  // certainly out of it does not change the star. Empty, the default, if the star is not known to
  // be final.
  std::optional<double> final_reach;
};

enum class star_search { near, thorough };

// Proposes neighbours that a star probably has, before it is made; none by default.
struct star_proposal {
  // Neighbours that the star probably has, counter-clockwise. They are used if exact tests find
  // that each is accepted and, where the mesher confirms stars, confirm the star against all sites.
  std::span<const vertex_index> guess = {};
  // True if doubles decided for each of these neighbours that it is accepted, without doubt: where
  // the auditor confirms the star, that is not tested again.
  bool is_plain = false;
  star_confirmation confirmed = star_confirmation::by_mesher;
  std::span<const vertex_index> others = {};  // offered to it besides what is near
};

// Constructs the star of v. Deterministic: a function of the sites, the boundary, v, the search and
// the proposal alone.
constructed_star construct_star(const site_oracle& oracle, vertex_index v,
                                star_search search = star_search::thorough,
                                const star_proposal& proposed = {});

// Returns the distance from v to the farthest Voronoi vertex of the star's gaps, as v measures;
// infinite when a gap has none. In doubles, for choosing the radius of a search.
double farthest_vertex(const site_oracle& oracle, vertex_index v, const star& s);
// Returns the greater of farthest_vertex() and the distance of the farthest neighbour. Leaves out
// gaps of less than half a turn that have no Voronoi vertex: where metrics vary fast, no distance
// would be enough for these gaps.
double farthest_known_vertex(const site_oracle& oracle, vertex_index v, const star& s);

}  // namespace asterism::internal
