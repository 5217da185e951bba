// SPDX-License-Identifier: MIT
//
// Compares the metric of a mesh with the one wanted, and finds contradictions to a report of that
// distance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/past_audit.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Reports the distance of the mesh's metric from the wanted one, without the length factor. Fails
// if `wanted` cannot be evaluated at a site. An audit of the mesh, if not null, saves checks that
// no tensor affects.
result<delivered_report> compare_with_wanted(const mesh& m, const metric_field& wanted,
                                             std::optional<double> angle_bound,
                                             const past_audit* audited = nullptr);

// Returns a sentence for each number of the first report that differs from the second's, to the
// last bit; the length factor is not compared.
std::vector<std::string> contradictions_in_delivered(const delivered_report& claimed,
                                                     const delivered_report& measured);

// Returns a sentence for each number of claim.delivered that differs, to the last bit, from the one
// measured; none where the claim has no such report.
std::vector<std::string> contradictions_in_delivered(const mesh& subject, const certificate& claim,
                                                     const metric_field& wanted);

}  // namespace asterism::internal
