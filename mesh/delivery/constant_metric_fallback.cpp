// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/constant_metric_fallback.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/delivery/count_search.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/delivery/shortest_given_edge.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/refine/site_budget.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Work limit of one mesh: in units of kernels/work_units.hpp, and as a share of the limit for its
// number of sites.
struct work_allowed {
  double units, share;
};

std::size_t sites_of(const domain& shape, const filled_domain& proposed) {
  std::size_t sites = shape.vertices.size() + proposed.interior.size();
  for (const std::vector<site>& division : proposed.divisions) sites += division.size();
  return sites;
}

// Makes a mesh of a job whose field is one metric. Returns none where sites cannot be spread, the
// run is stopped before, or no work is left. Counts the work of this mesh from zero.
std::optional<mesh_outcome> mesh_of(const meshing_context& job, const work_allowed& work) {
  auto filled = fill_within_budget(job);
  if (!filled) return std::nullopt;
  const filled_domain& proposed = filled.value().proposed;
  if (proposed.crowded || (proposed.stopped && job.options.stop.told())) return std::nullopt;
  const double allowed = most_work_units(sites_of(job.shape, proposed), job.shape.vertices.size());
  const double share = std::min(work.share, work.units / allowed);
  if (!(share > 0)) return std::nullopt;
  tier_counters own;
  const auto own_kernel = job.kernel.fork(own);
  meshing_context limited = job.on(*own_kernel);
  limited.work_share = share;
  auto made = mesh_from_sites(limited, std::move(filled).value());
  job.kernel.counters() += own;
  return made ? std::optional(std::move(made).value()) : std::nullopt;
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
  auto made = mesh_of({stars_on, shape, *field, asked}, {infinity, part_of_work});
  if (!made || !made->complete) return std::nullopt;
  return std::move(made->result);
}

class constant_metric_fallback {
 public:
  constant_metric_fallback(const meshing_context& job, mesh_outcome as_given)
      : job_(job),
        domain_(job.shape),
        field_(job.field),
        options_(job.options),
        as_given_(std::move(as_given)),
        unit_(job.shape, job.field, job.options),
        frame_(unit_.frame()),
        image_(unit_.shape()) {}

  result<mesh_outcome> run() {
    if (auto failure = measure_sites()) return *failure;
    // Tries the metric itself where it is the same everywhere: stars agree in every such metric
    // (docs/math/refinement.md). Where they still disagree, the limit on sites or on work was met.
    // The mean computed in doubles may be a slightly less thin metric, with which a mesh keeps
    // within that limit; its distance is reported.
    if (is_same_everywhere_) {
      if (is_final(attempt(false))) return conclude();
      is_same_everywhere_ = false;
      if (auto failure = measure_sites(false)) return *failure;
    }
    for (const bool has_demands : {true, false})
      if (is_final(attempt(has_demands))) return conclude();
    return std::move(as_given_);
  }

 private:
  // Computes the mean of the metric, in the unit frame.
  std::optional<error> measure_sites(bool may_be_constant = true) {
    std::vector<metric_tensor> tensors;
    field_.expect([this] { return positions_of(as_given_.result.sites); });
    for (const site& s : as_given_.result.sites) {
      const auto m = field_.at(s.position);
      if (!m) return m.failure();
      tensors.push_back(frame_.inward(m.value()));
    }
    is_same_everywhere_ = may_be_constant && is_same_at_all_places(tensors[0], tensors);
    mean_ = is_same_everywhere_ ? tensors[0] : mean_of(tensors);
    return std::nullopt;
  }

  // True if sites and places of a lattice over the box all have this tensor, bit for bit. Then
  // another metric would not help, and the obstacle is the domain or a limit.
  bool is_same_at_all_places(const metric_tensor& one,
                             const std::vector<metric_tensor>& at_sites) const {
    if (std::any_of(at_sites.begin(), at_sites.end(),
                    [&one](const metric_tensor& m) { return !(m == one); }))
      return false;
    constexpr int lattice = 24;
    const bounding_box box = image_.box();
    for (int i = 0; i < lattice * lattice; ++i) {
      const int column = i % lattice, row = i / lattice;
      const double u = (column + 0.5) / lattice, v = (row + 0.5) / lattice;
      const auto there = unit_.field().at(
          {(1 - u) * box.low.x + u * box.high.x, (1 - v) * box.low.y + v * box.high.y});
      if (there && !(there.value() == one)) return false;
    }
    return true;
  }

  // Makes a mesh in the mean metric, with or without the demands; returns none where there is no
  // such mesh.
  std::optional<mesh_outcome> attempt(bool has_demands) {
    has_demands_ = has_demands;
    if (is_stopped() || !(units_left() > least_left * units_for_constant_metric))
      return std::nullopt;
    mesh_options options = options_;
    if (!has_demands) {
      options.angle_bound = 0;
      options.limit_size = false;
    }
    const auto one = same_everywhere(mean_);
    auto made = mesh_of({job_.kernel, image_, *one, options, job_.progress}, {units_left(), 1});
    if (made) unit_.outward(*made);
    return made;
  }

  // Returns the work limit of one attempt, in units.
  double units_left() const {
    return std::min(options_.stop.units_left(), units_for_constant_metric);
  }

  bool is_stopped() {
    if (!stopped_) stopped_ = options_.stop.told();
    return stopped_.has_value();
  }

  // Keeps the mesh in tried_. Returns true if it is the mesh to show, or the run is stopped.
  bool is_final(std::optional<mesh_outcome> tried) {
    tried_ = std::move(tried);
    if (stopped_ || !tried_) return is_stopped();
    const bool agrees = tried_->disagreeing == 0 && tried_->ended.stars_missing == 0 &&
                        tried_->ended.how != ending::crowded;
    return agrees || tried_->stopped;
  }

  result<mesh_outcome> conclude() {
    if (stopped_ || tried_->stopped) {
      as_given_.stopped = true;
      as_given_.stopped_in_one_metric.emplace();
      if (stopped_) {
        as_given_.stopped_in_one_metric->how = ending::stopped;
        as_given_.stopped_in_one_metric->stopped_because = *stopped_;
      } else {
        as_given_.stopped_in_one_metric = tried_->ended;
      }
      return std::move(as_given_);
    }
    auto compared = compare_with_wanted(tried_->result, field_, options_.angle_bound);
    if (!compared) return compared.failure();
    tried_->one_metric = {as_given_.ended, too_close_in(as_given_), has_demands_,
                          is_same_everywhere_, options_.angle_bound};
    if (!has_demands_) {
      tried_->complete = false;
      if (auto failure = count_large()) return *failure;
    }
    if (!is_same_everywhere_) tried_->delivered = std::move(compared).value();
    return *std::move(tried_);
  }

  // Counts the triangles that are too large by the metric given: an attempt without demands has not
  // counted them.
  std::optional<error> count_large() {
    if (!options_.limit_size) return std::nullopt;
    mesh as_given = tried_->result;
    for (site& s : as_given.sites) {
      const auto given = field_.at(s.position);
      if (!given) return given.failure();
      s.metric = given.value();
    }
    tried_->too_large = static_cast<std::size_t>(std::count_if(
        as_given.triangles.begin(), as_given.triangles.end(), [&as_given](const triangle& t) {
          return metric_circumradius({as_given.sites[t[0]], as_given.sites[t[1]],
                                      as_given.sites[t[2]]}) > largest_circumradius;
        }));
    return std::nullopt;
  }

  // Share of the work limit that must be left for an attempt to begin.
  static constexpr double least_left = 0.1;

  const meshing_context& job_;
  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  mesh_outcome as_given_;
  normalised_problem unit_;
  const unit_frame& frame_;
  const domain& image_;  // in the frame, as the mean
  metric_tensor mean_;
  bool is_same_everywhere_ = false;
  std::optional<mesh_outcome> tried_;
  bool has_demands_ = true;             // of the last attempt
  std::optional<std::string> stopped_;  // why, between meshes
};

}  // namespace

bool wants_other_metric(const mesh_outcome& made, const mesh_options& options) {
  return options.strategy == refinement_strategy::fill && !made.stopped && !made.complete &&
         (made.disagreeing > 0 || made.ended.stars_missing > 0 ||
          made.ended.how == ending::crowded);
}

result<mesh_outcome> refine_in_one_metric(const meshing_context& job, mesh_outcome as_given) {
  return constant_metric_fallback(job, std::move(as_given)).run();
}

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

// Makes meshes in multiples of the metric, in which stars and angles are the same, until the number
// of sites fits. The sites then have the metric itself.
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
