// SPDX-License-Identifier: MIT
//
// Tells whether a star is *final*: no site at all would be accepted by it.
//
// Tests every site that is not certainly out of reach (lemma 4.3 of docs/math/certificate.md; the
// bounds are those of site_index.hpp and of prepared gaps, and rigorous). Does not test whether the
// star's own neighbours are accepted.
#pragma once

#include <optional>

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

// Treatment of a gap without a bound on its reach: test all sites between its rays, or give up.
enum class unbounded_gaps { ask_all, give_up };

// Returns R of the lemma, in v's metric, if the star of v is final; none if a site would be
// accepted, or where a gap without a bound is given up. R is the greatest reach of its gaps
// (star_gap::reach). It is infinite if no bound is found, and for a star at a subsegment of the
// boundary, which may be split. A site that comes later and is certainly out of that reach cannot
// change the star. Requires a neighbourhood.
std::optional<double> final_reach(const site_oracle& oracle, vertex_index v, const star& s,
                                  unbounded_gaps unbounded = unbounded_gaps::ask_all);

}  // namespace asterism::internal
