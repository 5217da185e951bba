// SPDX-License-Identifier: MIT
//
// Names the steps that make a metric, in order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/solution/solution_metric_options.hpp"

namespace asterism::internal {

// Returns the steps for these options, each as a word and its argument. `fields` is 0 for a metric
// that is given, `others` counts the metrics to intersect with; `given` says that second
// derivatives were not recovered, `layers` is the least bound on aspects of fields that were
// computed.
std::vector<std::string> metric_steps(const solution_metric_options& options, std::size_t fields,
                                      std::size_t others, bool given, std::optional<double> layers);

}  // namespace asterism::internal
