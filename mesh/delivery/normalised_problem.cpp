// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/normalised_problem.hpp"

namespace asterism::internal {

// Chooses the frame. The metric is scaled as well if its unit is arbitrary, no size being asked
// for.
normalised_problem::normalised_problem(const domain& d, const metric_field& field,
                                       const mesh_options& options)
    : field_(field),
      frame_(unit_frame::choose(d, field, !options.limit_size && !options.tolerance)),
      shape_(frame_.inward(d)),
      framed_(field, frame_) {}

void normalised_problem::outward(mesh_outcome& outcome) const {
  if (frame_.is_identity()) return;
  frame_.outward(outcome.result);
  refinement_ending& ended = outcome.ended;
  ended.tolerance = frame_.length_outward(ended.tolerance);
  if (ended.steep) {
    ended.steep->at = frame_.outward(ended.steep->at);
    ended.steep->spacing = frame_.length_outward(ended.steep->spacing);
  }
  if (ended.sharpest) ended.sharpest->at = frame_.outward(ended.sharpest->at);
  if (ended.crowded) ended.crowded->where = frame_.outward(ended.crowded->where);
}

}  // namespace asterism::internal
