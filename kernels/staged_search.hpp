// SPDX-License-Identifier: MIT
//
// Decides an insertion question by one arithmetic, with parameters that plain doubles propose:
// first the two Voronoi vertices that usually decide, then every equidistance cut.
#pragma once

#include <array>
#include <type_traits>

#include "asterism/kernels/arc_search.hpp"
#include "asterism/kernels/proposal.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/kernels/vertex_hints.hpp"

namespace asterism::internal {

// Searches in stages; `proposing` is the question in doubles. `most_ranges` bounds the cover.
template <class PointOnArc, class Number, class Source>
uncertain_bool search_in_stages(const insertion_question<Number>& question,
                                const insertion_question<Source>& source,
                                const insertion_question<double>& proposing, int most_ranges) {
  constexpr int most_quick_ranges = 8;
  const auto search = [&](const numeric::search_hints& hints, int budget) {
    return arc_search<Number, PointOnArc, Source>(question, source, hints, budget).exists();
  };
  if (const auto hints = proposal([&] { return numeric::find_quick_hints(proposing); })) {
    const uncertain_bool answer = search(*hints, most_quick_ranges);
    if (answer.certain()) return answer;
  }
  return search(proposal([&] { return numeric::find_hints(proposing); }), most_ranges);
}

// Searches sites of moderate magnitude (kernels/magnitude.hpp). Source is as in arc_search: the
// arithmetic of the coefficients.
template <class Number, class PointOnArc, class Source = Number>
uncertain_bool search_in_stages(const std::array<site, 4>& s, int most_ranges) {
  const double turn = std::ldexp(1.0, turn_scale_exponent(s[0].metric));
  const auto proposing =
      proposal([&] { return insertion_question<double>(s[0], s[1], s[2], s[3], turn); });
  const auto ask_in = [&]<class Type>(std::type_identity<Type>) {
    return insertion_question<Type>(convert<Type>(s[0]), convert<Type>(s[1]), convert<Type>(s[2]),
                                    convert<Type>(s[3]), Type(turn));
  };
  const auto question = ask_in(std::type_identity<Number>{});
  if constexpr (std::is_same_v<Number, Source>)
    return search_in_stages<PointOnArc>(question, question, proposing, most_ranges);
  else
    return search_in_stages<PointOnArc>(question, ask_in(std::type_identity<Source>{}), proposing,
                                        most_ranges);
}

}  // namespace asterism::internal
