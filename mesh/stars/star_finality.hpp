// SPDX-License-Identifier: MIT
//
// Is a star *final*: would no site at all be accepted by it?
//
// Every site not certainly out of reach is asked (lemma 4.3 of docs/math/certificate.md; the bounds
// are those of site_index.hpp and of prepared gaps, and rigorous). Whether the star's own
// neighbours stand is not asked here.
#pragma once

#include <optional>

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

// Returns R of the lemma, in v's metric, when the star of v is final: the greatest of its gaps'
// (star_gap::reach), infinite when not known and for a star at a subsegment of the boundary, which
// may be split. A site that comes later and is certainly out of that reach cannot change the star.
// None when a site would be accepted. Requires a neighbourhood.
std::optional<double> final_reach(const site_oracle& oracle, vertex_index v, const star& s);

}  // namespace asterism::internal
