// SPDX-License-Identifier: MIT
//
// Makes a net of the sites that a fill proposed: takes out those that are too near to others, and
// adds sites until the domain is covered. This is Algorithm A of docs/math/refinement.md, begun at
// any sites; docs/math/guarantee.md says what follows of its outcome.
#pragma once

#include <cstddef>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Metric lengths of a net, and how many sites it may have.
struct net_options {
  double covering =
      0;  // every point of the domain is to be within this of a site, as that measures
  double spacing =
      0;  // sites inside are to be as far from earlier ones, as one of the two measures
  std::size_t max_sites = 100000;
  cancellation stop = {};
};

struct net_report {
  std::size_t taken_out = 0, added = 0;
  // False if the limit on sites was reached, the run is to stop, or the boxes that cover the domain
  // would have to be smaller than doubles can represent.
  bool covered = false;
};

// Completes `proposed`. Vertices and points that divide segments stay. An added site is farther
// than 1 - 2^-20 of `covering` from all others, as they measure, so that adding ends by packing.
// Distances are in doubles, off by some 2^-50 of themselves. Charges the account of `stop`, and
// adds the work to that of `proposed`. Empties the likely stars of `proposed` where sites have
// changed. Deterministic. Requires a complete fill. Fails where the field does.
result<net_report> complete_net(const domain& d, const metric_field& field,
                                const net_options& options, filled_domain& proposed);

}  // namespace asterism::internal
