// SPDX-License-Identifier: MIT
#include "asterism/apps/vertex_count.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "asterism/mesh/pipeline/count_search.hpp"

namespace asterism::apps {

std::size_t vertices_aimed_at(const mesh_job& job) {
  const mesh_options& options = job.refinement;
  return internal::count_aimed_at(*options.vertices, job.vertices_factor, options.max_sites);
}

void meet_vertex_count(const mesh_job& job, const cancellation& stop, const make_mesh_of_job& make,
                       prepared_input& input, certified_mesh& made) {
  const auto wanted = job.refinement.vertices;
  if (!wanted || !made.certified()) return;
  std::optional<result<prepared_input>> other_input;
  std::optional<result<certified_mesh>> other;
  const auto attempt = [&](double factor, const cancellation& bounded) {
    mesh_job once_more = job;
    once_more.vertices_factor = factor;
    once_more.quiet = true;  // what there is to say of the domain was said
    other_input = prepare(once_more);
    std::optional<std::size_t> sites;
    if (!*other_input) return sites;
    once_more.quiet = job.quiet;
    other = make(once_more, other_input->value(), bounded);
    if (*other && other->value().certified()) sites = other->value().outcome.sites;
    return sites;
  };
  const auto keep = [&] {
    input = std::move(*other_input).value();
    made = std::move(*other).value();
  };
  internal::meet_count(*wanted, made.outcome.sites, stop, attempt, keep);
}

std::string vertex_count_text(std::size_t wanted, std::size_t delivered) {
  const double more = 100 * (static_cast<double>(delivered) / static_cast<double>(wanted) - 1);
  const bool is_near = internal::is_count_near(wanted, delivered);
  return fmt::format("vertices: {} wanted, {} delivered ({:+.1f} %{})", wanted, delivered, more,
                     is_near ? "" : ": none nearer to that were found");
}

}  // namespace asterism::apps
