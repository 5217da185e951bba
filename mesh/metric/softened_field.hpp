// SPDX-License-Identifier: MIT
//
// Makes fields that vary more slowly than a given one, for pipeline/metric_relaxation.hpp.
//
// All are positive definite wherever they do not fail; tensors as numerics/metric_algebra.hpp takes
// them.
#pragma once

#include <memory>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Returns a field with as many sites everywhere and less thin triangles: the aspects are raised to
// a power from 0 to 1. `field` must outlive it, and fails where it does.
std::unique_ptr<metric_field> soften(const metric_field& field, double power);

// grade_metric (metric/graded_field.hpp) for lengths wanted to differ by `beta` at most over the
// metric length `reach`. Empty where gradation changes nothing, fails, or is stopped. In
// the box, but outside the domain, `field` may fail: that has no influence elsewhere. `typical` is
// a tensor it may have.
std::unique_ptr<metric_field> grade_over(const metric_field& field, const bounding_box& box,
                                         double beta, double reach, const metric_tensor& typical,
                                         const cancellation& stop = {});

std::unique_ptr<metric_field> same_everywhere(const metric_tensor& m);

// Returns the log-Euclidean mean; of one tensor at least.
metric_tensor mean_of(const std::vector<metric_tensor>& tensors);

// Returns the field with a check that its tensors are finite and positive definite.
std::unique_ptr<metric_field> checked(std::unique_ptr<metric_field> field);

}  // namespace asterism::internal
