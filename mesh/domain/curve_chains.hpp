// SPDX-License-Identifier: MIT
//
// Keeps the curves of a domain while check_domain puts the domain in order.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Refuses a curve of which two vertices in a row are not joined by a segment: it was not divided
// yet, or belongs to another domain.
std::optional<error> check_curve_chains(const domain& d);

// Returns the curves of `input` in the numbers of the vertices of `kept`: vertex v of `input` is
// `renumbered[first_alike[v]]`, where it was kept. Refuses a curve of which a chord was dropped,
// cut, or covered by another's.
result<std::vector<domain_curve>> kept_curves(const domain& input,
                                              const std::vector<vertex_index>& first_alike,
                                              const std::vector<vertex_index>& renumbered,
                                              const domain& kept);

}  // namespace asterism::internal
