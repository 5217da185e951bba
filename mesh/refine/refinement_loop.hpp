// SPDX-License-Identifier: MIT
//
// The refinement loop: survey, repair stars, insert a site, until nothing is bad or nothing helps.
#pragma once

#include <functional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/site_budget.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// make_mesh on any kernel; fills everything of the outcome but the counters. With a kernel that is
// not exact the outcome claims what that kernel believes.
result<mesh_outcome> mesh_domain(const star_predicates& kernel, const domain& d,
                                 const metric_field& field, const mesh_options& options,
                                 const std::function<void(const mesh_progress&)>& progress);

// The same from sites proposed already, which must not be crowded.
result<mesh_outcome> mesh_from_sites(const budgeted_filling& filled, const star_predicates& kernel,
                                     const domain& d, const metric_field& field,
                                     const mesh_options& options,
                                     const std::function<void(const mesh_progress&)>& progress);

}  // namespace asterism::internal
