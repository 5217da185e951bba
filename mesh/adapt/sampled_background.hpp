// SPDX-License-Identifier: MIT
//
// Samples a metric at the nodes of a triangulation that is so fine that interpolating between them
// comes near to it.
//
// The metric of a formula is only known where it is asked for. Edges are halved while the metric
// half way along them is another than the one interpolated from their ends, or they are long as it
// measures them. Edges along which nothing changes stay long, so that a front is sampled finely
// across and coarsely along. Where the metric jumps no sampling is fine enough; there the least
// length ends it. Narrow details between all samples are missed: what is bounded is the difference
// at the middle of every edge that was looked at. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

struct sampling_limits {
  double difference = 0.2;  // log distortion allowed between the metric sampled and interpolated
  double longest = 1;       // an edge may be, as the metric measures it
  double shortest = 0.35;   // edges below this stay, whatever the metric does on them
  // Part of the domain's extent that an edge may be long, so that what is narrow is noticed.
  double part_of_domain = 1.0 / 24;
  std::size_t most_nodes = 60000;  // sampling ends at this many
  cancellation stop;
};

struct sampled_background {
  mesh nodes;  // those of the triangulation, and those added, with the metric there
  // Length of the longest edge that was left as it is, as its ends and its middle measure it. With
  // a limit of no less the background would have been the same.
  double longest = 0;
};

// Returns nothing where the metric fails.
std::optional<sampled_background> sample_background(working_mesh m, const metric_field& field,
                                                    const sampling_limits& limits);

}  // namespace asterism::internal::adapting
