// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/one_metric.hpp"

#include <cmath>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::internal {

std::unique_ptr<metric_field> one_metric_for(const adapting::nodal_field& wanted,
                                             const mesh& start) {
  const metric_tensor mean = mean_of(wanted.tensors());
  mesh same = start;
  for (site& s : same.sites) s.metric = mean;
  const double factor = wanted.complexity() / adapting::nodal_field(same).complexity();
  const metric_tensor one{mean.m11 * factor, mean.m12 * factor, mean.m22 * factor};
  const bool is_metric =
      factor > 0 && std::isfinite(one.m11 + one.m22) && one.m11 * one.m22 - one.m12 * one.m12 > 0;
  return is_metric ? same_everywhere(one) : nullptr;
}

std::optional<mesh_outcome> mesh_in_one_metric(const domain& shape, const metric_field& metric,
                                               const mesh_options& options, bool has_demands) {
  constexpr double part_of_work = 0.3;
  mesh_options asked = options;
  asked.limit_size = has_demands;
  if (!has_demands) asked.angle_bound = 0;
  asked.vertices.reset();
  asked.keep_if_complete = false;
  asked.improve_passes = 0;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  auto made = mesh_domain({stars_on, shape, metric, asked, {}, part_of_work});
  if (!made) return std::nullopt;
  const mesh_outcome& o = made.value();
  if (o.disagreeing > 0 || o.ended.stars_missing > 0 || o.ended.how == ending::crowded)
    return std::nullopt;
  return std::move(made).value();
}

}  // namespace asterism::internal
