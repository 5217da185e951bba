// SPDX-License-Identifier: MIT
//
// An insertion question asked of one arithmetic, with the parameters that plain doubles propose:
// first the two Voronoi vertices that usually decide, then every equidistance cut.
#pragma once

#include "asterism/kernels/arc_search.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/kernels/vertex_hints.hpp"

namespace asterism {

// Requires sites of harmless magnitude (kernels/magnitude.hpp). `most_ranges` bounds the cover.
template <class Number, class PointOnArc>
uncertain_bool search_in_stages(const std::array<site, 4>& s, int most_ranges) {
  constexpr int most_quick_ranges = 8;
  const double turn = std::ldexp(1.0, turn_scale_exponent(s[0].metric));
  const insertion_question<double> proposing(s[0], s[1], s[2], s[3], turn);
  const insertion_question<Number> question(convert<Number>(s[0]), convert<Number>(s[1]),
                                            convert<Number>(s[2]), convert<Number>(s[3]),
                                            Number(turn));
  const auto search = [&](const numeric::search_hints& hints, int budget) {
    return arc_search<Number, PointOnArc>(question, hints, budget).exists();
  };
  if (const auto hints = numeric::find_quick_hints(proposing)) {
    const uncertain_bool answer = search(*hints, most_quick_ranges);
    if (answer.certain()) return answer;
  }
  return search(numeric::find_hints(proposing), most_ranges);
}

}  // namespace asterism
