// SPDX-License-Identifier: MIT
//
// The refinement loop: survey, repair stars, insert a site, until nothing is bad or nothing helps.
#pragma once

#include <functional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/refine_budget.hpp"
#include "asterism/mesh/star_kernel.hpp"

namespace asterism {

// make_mesh on any kernel; fills everything of the outcome but the counters. With a kernel that is
// not exact the outcome claims what that kernel believes.
result<refinement_outcome> refine_on(
    const star_kernel& kernel, const domain& d, const metric_field& field,
    const refinement_options& options,
    const std::function<void(const refinement_progress&)>& progress);

// The same from sites proposed already, which must not be crowded.
result<refinement_outcome> refine_from(
    const budgeted_filling& filled, const star_kernel& kernel, const domain& d,
    const metric_field& field, const refinement_options& options,
    const std::function<void(const refinement_progress&)>& progress);

}  // namespace asterism
