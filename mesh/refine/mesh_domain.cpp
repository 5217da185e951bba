// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/mesh_domain.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/refine/coarser_mesh.hpp"
#include "asterism/mesh/refine/refinement_loop.hpp"

namespace asterism::internal {
namespace {

// Refines the proposal in the field divided by 2^halvings.
result<mesh_outcome> refine_coarser(const meshing_context& job, filled_domain proposed,
                                    int halvings) {
  if (halvings == 0) return refine(job, std::move(proposed));
  const coarser_field coarser(job.field, halvings);
  auto made = refine(job.in(coarser), std::move(proposed));
  if (made) restore_lengths(halvings, made.value());
  return made;
}

// Returns the mesh of the given vertices alone, with no further site allowed: complete if no
// triangle is bad.
result<mesh_outcome> mesh_as_given(const meshing_context& job, int halvings) {
  mesh_options options = job.options;
  options.max_sites = job.shape.vertices.size();
  filled_domain nothing;
  nothing.divisions.resize(job.shape.segments.size());
  auto made = refine_coarser(job.with(options), std::move(nothing), halvings);
  if (!made || !made.value().complete) return made;
  made.value().ended.nothing_added = true;
  report_coarser(halvings, false, job.options, made.value());
  return made;
}

bool is_final(const result<mesh_outcome>& kept) {
  return !kept || kept.value().ended.sites_wanted > 0 || kept.value().complete ||
         kept.value().stopped;
}

// Returns the mesh of the given vertices alone in place of a crowded fill. In such a fill each site
// is in reach of most others: exact stars would take hours.
result<mesh_outcome> mesh_without(const crowded_site& crowded, const meshing_context& job) {
  auto kept = mesh_as_given(job, 0);
  if (!kept || kept.value().complete) return kept;
  kept.value().ended.how = ending::crowded;
  kept.value().ended.crowded = crowded;
  return kept;
}

}  // namespace

std::optional<error> check_options(const domain& d, const mesh_options& o) {
  const auto refuse = [](const std::string& what, const std::string& got) {
    return error{what + ", not " + got, error_code::bad_option};
  };
  if (!(o.angle_bound >= 0 && o.angle_bound < 60))
    return refuse("the angle bound must be at least 0 and less than 60 degrees",
                  format_number(o.angle_bound));
  if (o.tolerance && !(*o.tolerance > 0 && std::isfinite(*o.tolerance)))
    return refuse("the tolerance must be positive and finite", format_number(*o.tolerance));
  if (o.max_rejected < 1)
    return refuse("the number of rejected darts must be at least 1",
                  std::to_string(o.max_rejected));
  if (o.max_sites < d.vertices.size())
    return refuse("the limit on sites must be at least " + std::to_string(d.vertices.size()) +
                      ", the number of the domain's vertices",
                  std::to_string(o.max_sites));
  return std::nullopt;
}

result<mesh_outcome> mesh_domain(const meshing_context& job) {
  if (auto refused = check_options(job.shape, job.options)) return *refused;
  const bool keep = job.options.keep_if_complete;
  if (keep)
    if (auto kept = mesh_as_given(job, 0); is_final(kept)) return kept;
  auto filled = fill_within_budget(job);
  if (!filled) return filled.failure();
  if (const auto& crowded = filled.value().proposed.crowded) return mesh_without(*crowded, job);
  // Keeps the mesh of the given vertices alone if it is complete after at most two more halvings of
  // the number of sites than the fill took: such a mesh may already be as fine as the limit on
  // sites allows. A fill that keeps all these vertices may be finer than required, by a factor
  // below two in the length of edges.
  const int halvings = filled.value().halvings;
  const int coarsest = halvings > 0 && keep ? halvings + 2 : 0;
  for (int fewer = 1; fewer <= coarsest; ++fewer)
    if (auto kept = mesh_as_given(job, fewer); is_final(kept)) return kept;
  return mesh_from_sites(job, std::move(filled).value());
}

result<mesh_outcome> mesh_from_sites(const meshing_context& job, budgeted_filling filled) {
  const bool stopped = filled.proposed.stopped;
  auto made = refine_coarser(job, std::move(filled.proposed), filled.halvings);
  if (made) report_coarser(filled.halvings, stopped, job.options, made.value());
  return made;
}

}  // namespace asterism::internal
