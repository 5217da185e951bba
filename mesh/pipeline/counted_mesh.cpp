// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/counted_mesh.hpp"

#include <optional>
#include <utility>

#include "asterism/mesh/pipeline/count_search.hpp"

namespace asterism {
namespace {

result<counted_mesh> make_once(const domain& d, const field_of_size& make,
                               const scale_demand& scale, const mesh_options& options,
                               const progress_listener& progress,
                               const std::vector<periodic_pair>& pairs) {
  auto metric = make_scaled_metric(d, make, scale);
  if (!metric) return metric.failure();
  auto made = make_periodic_mesh(d, *metric.value().field, options, pairs, progress);
  if (!made) return made.failure();
  return counted_mesh{std::move(made).value(), std::move(metric).value()};
}

// Makes it in the metric scaled to a number of vertices, times the factor.
result<counted_mesh> make_scaled(const domain& d, const field_of_size& make,
                                 const scale_demand& scale, const mesh_options& options,
                                 const progress_listener& progress,
                                 const std::vector<periodic_pair>& pairs, double factor) {
  mesh_options aiming = options;
  aiming.vertices = internal::count_aimed_at(*options.vertices, factor, options.max_sites);
  scale_demand scaled = scale;
  scaled.size.reset();
  scaled.complexity = factor * complexity_of_vertices(*options.vertices);
  return make_once(d, make, scaled, aiming, progress, pairs);
}

}  // namespace

result<counted_mesh> make_counted_mesh(const domain& d, const field_of_size& make,
                                       const scale_demand& scale, const mesh_options& options,
                                       const progress_listener& progress,
                                       const std::vector<periodic_pair>& pairs) {
  if (!options.vertices) return make_once(d, make, scale, options, progress, pairs);
  auto nearest = make_scaled(d, make, scale, options, progress, pairs, 1);
  if (!nearest || !nearest.value().made.certified()) return nearest;
  std::optional<result<counted_mesh>> tried;
  const auto attempt = [&](double factor, const cancellation& bounded) {
    mesh_options limited = options;
    limited.stop = bounded;
    tried = make_scaled(d, make, scale, limited, progress, pairs, factor);
    std::optional<std::size_t> sites;
    if (*tried && tried->value().made.certified()) sites = tried->value().made.outcome.sites;
    return sites;
  };
  const auto keep = [&] { nearest = std::move(*tried); };
  internal::meet_count(*options.vertices, nearest.value().made.outcome.sites, options.stop, attempt,
                       keep);
  return nearest;
}

}  // namespace asterism
