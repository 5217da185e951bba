// SPDX-License-Identifier: MIT
//
// Bundles the input of one refinement.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/fill/prescribed_divisions.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// Input of one refinement. The domain and the field are in the unit frame
// (metric/unit_frame.hpp), and so is the outcome: the pipeline scales both ways. All references
// must outlive the context.
struct meshing_context {
  const star_predicates& kernel;
  const domain& shape;  // accepted by check_domain
  const metric_field& field;
  const mesh_options& options;  // with the cancellation, options.stop
  progress_listener progress = {};
  double work_share = 1;  // of the work that is allowed for so many sites (stars/work_limit.hpp)
  star_confirmation confirmed = star_confirmation::by_mesher;
  const prescribed_divisions* prescribed = nullptr;  // by segment of the shape, in the frame

  // Return the same job with one member replaced.
  meshing_context on(const star_predicates& other) const {
    return {other, shape, field, options, progress, work_share, confirmed, prescribed};
  }
  meshing_context in(const metric_field& other) const {
    return {kernel, shape, other, options, progress, work_share, confirmed, prescribed};
  }
  meshing_context with(const mesh_options& other) const {
    return {kernel, shape, field, other, progress, work_share, confirmed, prescribed};
  }
};

}  // namespace asterism::internal
