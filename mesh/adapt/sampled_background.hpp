// SPDX-License-Identifier: MIT
//
// Samples a metric at the nodes of a triangulation fine enough for interpolation between them.
//
// The metric of a formula is only known where it is evaluated. Edges are halved while the metric
// half way along them differs from the one interpolated between their ends, or while they are long
// in it. Edges along which nothing changes stay long, so that a front is sampled finely across and
// coarsely along. Where the metric jumps no sampling is fine enough; there halving ends at the
// least length. Narrow details between all samples are missed: the bound is on the difference at
// the middle of every edge that was tested. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

struct sampling_limits {
  double difference = 0.2;  // log distortion allowed between the metric sampled and interpolated
  double longest = 1;       // an edge may be, as the metric measures it
  double shortest = 0.35;   // edges below this stay, whatever the metric does on them
  // Greatest length of an edge as a part of the domain's extent, so that narrow features are
  // sampled.
  double part_of_domain = 1.0 / 24;
  std::size_t most_nodes = 60000;  // sampling ends at this many
  cancellation stop;
};

struct sampled_background {
  mesh nodes;  // those of the triangulation, and those added, with the metric there
  // Greatest length of an edge that was not halved, in the metrics at its ends and its middle. A
  // limit on lengths at or above this would have given the same background.
  double longest = 0;
};

// Samples the metric. Returns nothing where the metric fails.
std::optional<sampled_background> sample_background(editable_mesh m, const metric_field& field,
                                                    const sampling_limits& limits);

}  // namespace asterism::internal::adapting
