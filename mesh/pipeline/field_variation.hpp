// SPDX-License-Identifier: MIT
//
// Samples how fast a metric field varies in a domain, and looks for places where it jumps.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Two points at which the metrics differ, adjacent at the resolution of doubles of the domain's
// size.
struct field_jump {
  point from, to;
  double factor = 1;  // the distortion between them
};

// The variation and the first jump that samples of a field show. Between samples the field may vary
// faster, and jump: no bound follows.
struct field_samples {
  // The greatest (1 - 1 / tau) / d of two sampled points, d the smaller of their distances: the
  // field's sigma is at least that (docs/math/refinement.md, H1).
  double variation = 0;
  std::optional<field_jump> jump;  // the first that was found
};

// Samples the field on a grid of points inside the domain, and further between neighbours of the
// grid whose metrics differ noticeably: there it follows the half over which the metric changes
// more. Fails where the field does. `d` must have been accepted by check_domain.
result<field_samples> sample_variation(const domain& d, const metric_field& field);

}  // namespace asterism::internal
