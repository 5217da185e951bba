// SPDX-License-Identifier: MIT
//
// Makes the metric wanted for a given size, or for the size that gives it the complexity wanted;
// graded if that is asked for.
//
// The complexity of a metric is the domain's area in it, the integral of sqrt(det M). A mesh of
// unit edges has about 2 / sqrt 3 vertices for each unit of complexity: equilateral triangles of
// side 1 have an area of sqrt 3 / 4, and there are two for each vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// Makes the metric for edges of this length, as make_metric_field and make_interpolated_field do.
// Called several times.
using field_of_size = std::function<result<std::unique_ptr<metric_field>>(double size)>;

// Demands on the scale of a metric. At most one of `size` and `complexity`.
struct scale_demand {
  std::optional<double> size;        // length of an edge; default: 1
  std::optional<double> complexity;  // positive, finite
  std::optional<double> gradation;   // beta, above 1
  cancellation stop = {};            // polled now and then
  size_wishes sizes = {};            // at places, in units of the domain: not scaled
  // The number of vertices that the complexity is for, if it is: for messages.
  std::optional<std::size_t> vertices = {};
};

// The scaled metric, and the size, gradation and complexity that it has.
struct scaled_metric {
  std::unique_ptr<metric_field> field;
  double size = 1;  // the one asked for, or found
  std::optional<gradation_report> gradation;
  std::optional<double> complexity;  // of the field, if one was asked for: within half a percent
  // Fingerprint of the mesh that the metric is given on, before anything is done to it; none where
  // it is given otherwise.
  std::optional<std::uint64_t> background_fingerprint;
};

// Returns the complexity for this number of vertices.
ASTERISM_EXPORT double complexity_of_vertices(std::size_t vertices);

// Makes the metric, refines it where local sizes are given (metric/local_sizes.hpp), then grades
// it. Gradation changes the complexity, and the size changes the gradation: both are repeated in
// turn until the complexity is within half a percent of the one wanted. Fails where the field does,
// for demands out of range, when stopped, and where twenty rounds do not reach that.
ASTERISM_EXPORT result<scaled_metric> make_scaled_metric(const domain& d, const field_of_size& make,
                                                         const scale_demand& wanted);

}  // namespace asterism
