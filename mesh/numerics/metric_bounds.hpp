// SPDX-License-Identifier: MIT
// Limits the lengths of edges that a metric prescribes, and the aspect of its triangles.
#pragma once

#include <cstdint>
#include <limits>

#include "asterism/core/site.hpp"

namespace asterism::internal {

struct size_bounds {
  double least = 0;                                           // length of an edge
  double greatest = std::numeric_limits<double>::infinity();  // the same
  double aspect = 1e6;
};

// Marks of the bounds that changed a tensor.
enum clipped : std::uint8_t {
  clipped_by_least = 1,
  clipped_by_greatest = 2,
  clipped_by_aspect = 4,
  clipped_by_step = 8,
  clipped_by_intersection = 16
};

// Returns the tensor with eigenvalues between 1 / greatest^2 and 1 / least^2, and then the smaller
// one raised to keep the aspect; the same bits where nothing had to change. Adds marks to `what`.
metric_tensor bounded(const metric_tensor& m, const size_bounds& bounds, std::uint8_t& what);

// Returns the tensor changed so that every length is between its length in `now` divided by
// `factor` and that times `factor`.
metric_tensor step_limited(const metric_tensor& m, const metric_tensor& now, double factor,
                           std::uint8_t& what);

}  // namespace asterism::internal
