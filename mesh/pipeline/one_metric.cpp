// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/one_metric.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"
#include "asterism/mesh/pipeline/count_search.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::internal {
namespace {

// Returns a mesh with unit edges that meets the demands, or none.
std::optional<mesh> unit_mesh(const domain& shape, const metric_tensor& metric,
                              const mesh_options& options) {
  constexpr double part_of_work = 0.3;
  mesh_options asked = options;
  asked.limit_size = true;
  asked.vertices.reset();
  asked.keep_if_complete = false;
  asked.improve_passes = 0;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const auto field = same_everywhere(metric);
  auto made = mesh_domain({stars_on, shape, *field, asked, {}, part_of_work});
  if (!made || !made.value().complete) return std::nullopt;
  return std::move(made.value().result);
}

}  // namespace

std::optional<metric_tensor> one_metric_for(const background_metric& wanted, const mesh& start) {
  const metric_tensor mean = mean_of(wanted.tensors());
  mesh same = start;
  for (site& s : same.sites) s.metric = mean;
  const double factor = wanted.complexity() / background_metric(same).complexity();
  const metric_tensor one = times(mean, factor);
  const bool is_metric =
      factor > 0 && std::isfinite(one.m11 + one.m22) && one.m11 * one.m22 - one.m12 * one.m12 > 0;
  return is_metric ? std::optional(one) : std::nullopt;
}

// Meshes multiples of the metric, in which stars and angles are the same, until the number of sites
// fits; the sites get the metric itself.
std::optional<mesh_of_one_metric> mesh_in_one_metric(const domain& shape,
                                                     const metric_tensor& metric,
                                                     const mesh_options& options,
                                                     std::size_t count) {
  constexpr int most_times = 6;
  constexpr double tolerable = 0.03;
  std::optional<mesh_of_one_metric> nearest;
  count_search search(static_cast<double>(count));
  for (int round = 0; round < most_times; ++round) {
    const double factor = search.factor();
    auto made = unit_mesh(shape, times(metric, factor), options);
    if (!made) break;
    if (search.take(static_cast<double>(made->sites.size())))
      nearest = {std::move(*made), 1 / std::sqrt(factor)};
    if (search.least_off() <= tolerable || !(options.stop.units_left() > 0)) break;
  }
  if (!nearest) return std::nullopt;
  for (site& s : nearest->made.sites) s.metric = metric;
  return nearest;
}

}  // namespace asterism::internal
