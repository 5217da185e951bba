// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/one_metric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::internal {
namespace {

metric_tensor scaled(const metric_tensor& m, double factor) {
  return {m.m11 * factor, m.m12 * factor, m.m22 * factor};
}

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

// Looks for the factor of the metric with which there are so many sites.
//
// They grow with the factor, in steps where a domain is narrow: all subsegments of one length are
// halved at once, and no factor may lead to a number between.
class count_search {
 public:
  explicit count_search(double wanted) : wanted_(wanted) {}

  // Returns the factor to try next, 1 to begin with.
  double factor() const { return elementary::exp(at_); }
  // Returns how far the nearest number found is off, as a logarithm.
  double least_off() const { return least_; }

  // Takes the number of sites found with the factor. Returns whether it is the nearest so far.
  //
  // Sites are taken to be as many as the factor says, until one factor was too large and one too
  // small. Then the next is between them, where a line through both meets the number wanted, but
  // not near an end.
  bool take(double sites) {
    constexpr double nearest_to_end = 0.2;
    const double off = elementary::log(sites / wanted_);
    const bool is_nearest = std::abs(off) < least_;
    if (is_nearest) least_ = std::abs(off);
    bound& side = off > 0 ? above_ : below_;
    side = {at_, off, true};
    if (above_.known && below_.known) {
      const double part =
          std::clamp(-below_.off / (above_.off - below_.off), nearest_to_end, 1 - nearest_to_end);
      at_ = below_.at + part * (above_.at - below_.at);
    } else {
      at_ -= off;
    }
    return is_nearest;
  }

 private:
  struct bound {
    double at = 0, off = 0;  // logarithms of the factor, and of how far the number is off
    bool known = false;
  };

  double wanted_, at_ = 0;  // the logarithm of the factor
  double least_ = std::numeric_limits<double>::infinity();
  bound above_, below_;
};

}  // namespace

std::optional<metric_tensor> one_metric_for(const adapting::nodal_field& wanted,
                                            const mesh& start) {
  const metric_tensor mean = mean_of(wanted.tensors());
  mesh same = start;
  for (site& s : same.sites) s.metric = mean;
  const double factor = wanted.complexity() / adapting::nodal_field(same).complexity();
  const metric_tensor one = scaled(mean, factor);
  const bool is_metric =
      factor > 0 && std::isfinite(one.m11 + one.m22) && one.m11 * one.m22 - one.m12 * one.m12 > 0;
  return is_metric ? std::optional(one) : std::nullopt;
}

// Stars and angles are the same in the metric times a number: sites are as dense as it takes, and
// have the metric itself.
std::optional<mesh_of_one_metric> mesh_in_one_metric(const domain& shape,
                                                     const metric_tensor& metric,
                                                     const mesh_options& options,
                                                     std::size_t count) {
  constexpr int most_times = 6;
  constexpr double tolerable = 0.03;
  std::optional<mesh_of_one_metric> nearest;
  count_search search(static_cast<double>(count));
  for (int times = 0; times < most_times; ++times) {
    const double factor = search.factor();
    auto made = unit_mesh(shape, scaled(metric, factor), options);
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
