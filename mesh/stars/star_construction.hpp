// SPDX-License-Identifier: MIT
//
// CONSTRUCTSTAR: the star of one site from all the others.
//
// The thesis looks at every site once, in any order; where Voronoi arcs are not wedged the result
// then depends on the order, and coarse stars keep neighbours they should not. Here sites are
// offered from near to far (as v measures; ties by position), again and again until the star is
// *settled*:
//   (a) every neighbour that is not forced passes its own test against the star without it,
//   (b) no other site that v sees is accepted.
// Both hold of the finished star, not only of some moment on the way. Sites already refused by the
// star as it stands are not asked again, so a star that settles costs little more than one round.
//
// With a neighbourhood only the sites near v are looked at, in two steps. Those within about twice
// the distance of the farthest Voronoi vertex make the star; where plain doubles guess it right
// (numerics/approximate_star.hpp), that is merely confirmed (stars/star_finality.hpp), against all
// sites there are if it can be. Then, if asked to be thorough, every site that is not certainly out
// of reach (site_index.hpp) is offered too.
#pragma once

#include <optional>

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

struct constructed_star {
  star content;
  // False when neighbours were still replacing each other after the bound on rounds
  // (stars/star_construction.cpp); (a) or (b) then fails.
  bool settled = false;
  // A thorough search changed what the near sites had made of it.
  bool repaired = false;
  // Known to be final (stars/star_finality.hpp), with this reach: no site there is belongs to it.
  std::optional<double> final_reach;
};

enum class star_search { near, thorough };

// Deterministic: a function of the sites, the boundary and v alone.
constructed_star construct_star(const site_oracle& oracle, vertex_index v,
                                star_search search = star_search::thorough);

// The distance from v to the farthest Voronoi vertex of the star's gaps, as v measures; infinite
// when a gap has none. In doubles, for choosing how far to look.
double farthest_vertex(const site_oracle& oracle, vertex_index v, const star& s);

}  // namespace asterism::internal
