// SPDX-License-Identifier: MIT
//
// Compares the metric of a mesh with the one wanted, and finds what contradicts such a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Makes the report but for the length factor. Fails where `wanted` does at a site.
result<delivered_report> compare_with_wanted(const mesh& m, const metric_field& wanted,
                                             std::optional<double> angle_bound);

// Returns a sentence for each number of the first report that is another one in the second, to the
// last bit, but for the length factor.
std::vector<std::string> contradictions_in_delivered(const delivered_report& claimed,
                                                     const delivered_report& measured);

// Returns a sentence for each number of claim.delivered that is another one, to the last bit; none
// where the claim has no such report.
std::vector<std::string> contradictions_in_delivered(const mesh& subject, const certificate& claim,
                                                     const metric_field& wanted);

}  // namespace asterism::internal
