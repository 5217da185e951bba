// SPDX-License-Identifier: MIT
//
// Measures the complexity of a metric, and grades a metric on the mesh or grid it is given on.
#pragma once

#include <memory>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Grades a metric: on the edges of its own mesh where it is given on one, else on a grid.
result<graded_metric> grade_as_given(std::unique_ptr<metric_field> field, const domain& d,
                                     const gradation_options& options);

// Returns the complexity of the field over the domain; for a field given on a mesh, over that mesh,
// by the tensors at its vertices.
result<double> complexity_over(const domain& d, const metric_field& field,
                               const cancellation& stop);

}  // namespace asterism::internal
