// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/piece_mesh.hpp"

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/pipeline/star_refusal.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism::internal {
namespace {

prescribed_divisions inward(const unit_frame& frame, const prescribed_divisions& divisions) {
  prescribed_divisions framed = divisions;
  for (auto& division : framed)
    if (division)
      for (point& q : *division) q = frame.inward(q);
  return framed;
}

result<mesh_outcome> make(const piece_shape& piece, const metric_field& field,
                          const mesh_options& options, const progress_listener& progress,
                          star_confirmation confirmed) {
  mesh_options bounded = options;
  bounded.stop = with_run_work(options.stop);
  bounded.stop.expect(piece.shape.vertices.size());
  const normalised_problem image(piece.shape, field, bounded);
  const prescribed_divisions divisions = inward(image.frame(), piece.divisions);
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  auto outcome = mesh_domain(
      {stars_on, image.shape(), image.field(), bounded, progress, 1, confirmed, &divisions});
  if (!outcome) return outcome;
  image.outward(outcome.value());
  outcome.value().counters = decided;
  assign_regions(outcome.value().result, piece.shape);
  return outcome;
}

}  // namespace

result<certified_mesh> make_piece_mesh(const piece_shape& piece, const metric_field& field,
                                       const mesh_options& options,
                                       const progress_listener& progress) {
  const auto judged = [&](star_confirmation confirmed, bool) -> result<certified_mesh> {
    auto made = make(piece, field, options, progress, confirmed);
    if (!made) return made.failure();
    if (progress) progress({.phase = mesh_phase::auditing, .sites = made.value().sites});
    return judge_outcome(std::move(made).value(), piece.shape, options);
  };
  return judged_until_confirmed(options, judged);
}

}  // namespace asterism::internal
