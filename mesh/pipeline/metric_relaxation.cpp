// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/metric_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/metric/constant_field.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/refine/site_budget.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/wide_range.hpp"

namespace asterism::internal {
namespace {

// Returns the ratios of lengths as b and a measure them: the greatest, and the greatest the other
// way.
std::pair<double, double> longer_and_shorter(const metric_tensor& b, const metric_tensor& a) {
  using number = wide_range;  // squares of tensors may leave the range of doubles
  const number a11 = a.m11, a12 = a.m12, a22 = a.m22, b11 = b.m11, b12 = b.m12, b22 = b.m22;
  const number determinant = a11 * a22 - a12 * a12;
  const number half = (b11 * a22 - number(2) * b12 * a12 + b22 * a11) / (number(2) * determinant);
  const number product = (b11 * b22 - b12 * b12) / determinant;
  const number greatest = half + root(half * half - product);
  const double longer = std::sqrt(static_cast<double>(greatest));
  return {longer, longer / std::sqrt(static_cast<double>(product))};
}

// The last resorts differ in whether there are demands; `reach` is the extent, in the frame.
struct relaxation_step {
  relaxation_kind kind = relaxation_kind::softened;
  double power = 1, beta = 1, reach = 1;  // as in relaxation_report
};

class relaxation {
 public:
  relaxation(const meshing_context& job, mesh_outcome as_given)
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
    // Stars agree in every metric that is the same everywhere (docs/math/refinement.md). Where they
    // are not found to, a limit on sites or on work is in the way, which a less thin metric, as the
    // mean computed in doubles may be, can keep within; how much it differs is told.
    if (is_same_everywhere_) {
      if (is_final(attempt({relaxation_kind::without_demands, 1, 1, extent_}))) return conclude();
      is_same_everywhere_ = false;
      if (auto failure = measure_sites(false)) return *failure;
    }
    for (const auto kind : {relaxation_kind::constant, relaxation_kind::without_demands})
      if (is_final(attempt({kind, 1, 1, extent_}))) return conclude();
    return std::move(as_given_);
  }

 private:
  // Measures the mean of the metric and the extent of the domain in it, both in the frame.
  std::optional<error> measure_sites(bool may_be_constant = true) {
    std::vector<metric_tensor> tensors;
    field_.expect([this] { return positions_of(as_given_.result.sites); });
    for (const site& s : as_given_.result.sites) {
      const auto m = field_.at(s.position);
      if (!m) return m.failure();
      tensors.push_back(frame_.inward(m.value()));
    }
    const bounding_box box = image_.box();
    is_same_everywhere_ = may_be_constant && is_same_at_all_places(tensors[0], tensors);
    mean_ = is_same_everywhere_ ? tensors[0] : mean_of(tensors);
    const double x = box.high.x - box.low.x, y = box.high.y - box.low.y;
    extent_ = std::sqrt(mean_.m11 * x * x + 2 * std::abs(mean_.m12) * x * y + mean_.m22 * y * y);
    return std::nullopt;
  }

  // True if sites and places of a lattice over the box all have this tensor, bit for bit. Then
  // another metric would not help, and what is in the way is the domain or a limit.
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

  // Makes a mesh by this step and leaves it in tried_. Leaves nothing where sites cannot be spread.
  const std::optional<mesh_outcome>& attempt(const relaxation_step& step) {
    step_ = step;
    tried_.reset();
    if (is_stopped() || !(units_left() > least_left * units_for_relaxing)) return tried_;
    mesh_options options = options_;
    if (step.kind == relaxation_kind::without_demands) {
      options.angle_bound = 0;
      options.limit_size = false;
    }
    const auto relaxed = same_everywhere(mean_);
    const meshing_context job = job_in_frame(*relaxed, options);
    const auto filled = fill_within_budget(job);
    if (!filled || (filled.value().proposed.stopped && is_stopped())) return tried_;
    spent_units_ += filled.value().work_units;
    if (filled.value().proposed.crowded) return tried_;
    refine(filled.value(), job);
    return tried_;
  }

  meshing_context job_in_frame(const metric_field& relaxed, const mesh_options& options) const {
    return {job_.kernel, image_, relaxed, options, job_.progress};
  }

  // Returns the units of work that the attempt may take. One metric for all sites, which is the
  // last resort, has as much again whatever the others took.
  double units_left() const {
    const bool is_last_resort =
        step_.kind == relaxation_kind::constant || step_.kind == relaxation_kind::without_demands;
    const double left = units_for_relaxing - spent_units_;
    return std::min(options_.stop.units_left(),
                    is_last_resort ? std::max(left, units_for_relaxing) : left);
  }

  // Returns the part of the work allowed for so many sites that is left for relaxing.
  double share_left(const filled_domain& proposed) const {
    std::size_t sites = image_.vertices.size() + proposed.interior.size();
    for (const std::vector<site>& division : proposed.divisions) sites += division.size();
    return units_left() / most_work_units(sites, image_.vertices.size());
  }

  void refine(const budgeted_filling& filled, const meshing_context& job) {
    const double share = share_left(filled.proposed);
    if (!(share > 0)) return;
    ++tries_;
    tier_counters own;  // the work done for one mesh is counted from zero
    const auto own_kernel = job.kernel.fork(own);
    meshing_context limited = job.on(*own_kernel);
    limited.work_share = std::min(1.0, share);
    auto made = mesh_from_sites(limited, filled);
    spent_units_ += work_units(own);
    job.kernel.counters() += own;
    if (!made) return;
    tried_ = std::move(made).value();
    unit_.outward(*tried_);
  }

  bool is_stopped() {
    if (!stopped_) stopped_ = options_.stop.told();
    return stopped_.has_value();
  }

  bool is_final(const std::optional<mesh_outcome>& tried) const {
    if (stopped_) return true;
    if (!tried) return false;
    const bool agrees = tried->disagreeing == 0 && tried->ended.stars_missing == 0 &&
                        tried->ended.how != ending::crowded;
    return agrees || tried->stopped;
  }

  result<mesh_outcome> conclude() {
    if (stopped_ || tried_->stopped) {
      as_given_.stopped = true;
      as_given_.stopped_relaxing.emplace();
      if (stopped_) {
        as_given_.stopped_relaxing->how = ending::stopped;
        as_given_.stopped_relaxing->stopped_because = *stopped_;
      } else {
        as_given_.stopped_relaxing = tried_->ended;
      }
      return std::move(as_given_);
    }
    relaxation_report report;
    report.why = ending_text(as_given_);
    report.kind = step_.kind;
    report.power = step_.power;
    report.beta = step_.beta;
    report.reach = frame_.length_outward(step_.reach);
    report.tries = tries_;
    if (auto failure = compare(report)) return *failure;
    judge(report);
    if (step_.kind == relaxation_kind::without_demands) tried_->complete = false;
    tried_->complete = tried_->complete && report.low_triangles.empty();
    tried_->relaxed = std::move(report);
    tried_->relaxed_details = {options_.angle_bound, is_same_everywhere_};
    return *std::move(tried_);
  }

  static std::size_t count_large(const mesh& m) {
    return static_cast<std::size_t>(
        std::count_if(m.triangles.begin(), m.triangles.end(), [&m](const triangle& t) {
          return metric_circumradius({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]}) >
                 largest_circumradius;
        }));
  }

  // Compares the sites' own tensors with those the field gives.
  std::optional<error> compare(relaxation_report& report) const {
    for (const site& s : tried_->result.sites) {
      const auto given = field_.at(s.position);
      if (!given) return given.failure();
      report.given.push_back(given.value());
      if (given.value() == s.metric) continue;
      ++report.changed;
      const auto [longer, shorter] =
          longer_and_shorter(frame_.inward(s.metric), frame_.inward(given.value()));
      report.most_longer = std::max(report.most_longer, longer);
      report.most_shorter = std::max(report.most_shorter, shorter);
    }
    return std::nullopt;
  }

  // Judges the angles in the metric given, by the auditor's exact test.
  void judge(relaxation_report& report) {
    mesh as_given = tried_->result;
    for (vertex_index v = 0; v < as_given.sites.size(); ++v)
      as_given.sites[v].metric = report.given[v];
    audit_options options;
    options.angle_bound = options_.angle_bound;
    options.find_exempt_corners = true;
    options.check_stars = false;
    const audit_report found = audit(as_given, options);
    report.worst_angle = found.worst().degrees;
    report.low_triangles = found.refused_triangles();
    // Without demands nobody has looked at sizes yet.
    if (options_.limit_size && step_.kind == relaxation_kind::without_demands)
      tried_->too_large = count_large(as_given);
  }

  // Part of the work for relaxing without which no attempt is begun.
  static constexpr double least_left = 0.1;

  const meshing_context& job_;
  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  mesh_outcome as_given_;
  unit_image unit_;
  const unit_frame& frame_;
  const domain& image_;  // in the frame, as the mean and the extent
  metric_tensor mean_;
  bool is_same_everywhere_ = false;
  double extent_ = 0;
  std::optional<mesh_outcome> tried_;
  relaxation_step step_;                // of the last attempt, as what follows
  std::optional<std::string> stopped_;  // why, between meshes
  std::size_t tries_ = 0;
  double spent_units_ = 0;  // of work, by all attempts
};

}  // namespace

bool wants_relaxation(const mesh_outcome& made, const mesh_options& options) {
  return options.relax && options.strategy == refinement_strategy::fill && !made.stopped &&
         !made.complete &&
         (made.disagreeing > 0 || made.ended.stars_missing > 0 ||
          made.ended.how == ending::crowded);
}

result<mesh_outcome> refine_relaxed(const meshing_context& job, mesh_outcome as_given) {
  return relaxation(job, std::move(as_given)).run();
}

}  // namespace asterism::internal
