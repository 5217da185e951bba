// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/metric_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/metric/softened_field.hpp"
#include "asterism/mesh/metric/unit_frame.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/optimize/optimize_mesh.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"
#include "asterism/mesh/refine/refinement_loop.hpp"
#include "asterism/mesh/refine/site_budget.hpp"

namespace asterism::internal {
namespace {

// The ratios of lengths as b and a measure them: the greatest, and the greatest the other way. In
// long doubles since squares of tensors may leave the range of doubles.
std::pair<double, double> longer_and_shorter(const metric_tensor& b, const metric_tensor& a) {
  const long double a11 = a.m11, a12 = a.m12, a22 = a.m22, b11 = b.m11, b12 = b.m12, b22 = b.m22;
  const long double determinant = a11 * a22 - a12 * a12;
  const long double half = (b11 * a22 - 2 * b12 * a12 + b22 * a11) / (2 * determinant);
  const long double product = (b11 * b22 - b12 * b12) / determinant;
  const long double greatest = half + std::sqrt(std::max(half * half - product, 0.0L));
  const double longer = std::sqrt(static_cast<double>(greatest));
  return {longer, longer / std::sqrt(static_cast<double>(product))};
}

// One way to make the metric slower; `reach` is in the frame.
struct relaxation_step {
  relaxation_kind kind = relaxation_kind::softened;
  double power = 1, beta = 1, reach = 1;  // as in relaxation_report
};

class relaxation {
 public:
  relaxation(const star_predicates& kernel, const domain& d, const metric_field& field,
             const mesh_options& options, const std::function<void(const mesh_progress&)>& progress,
             mesh_outcome as_given)
      : kernel_(kernel),
        domain_(d),
        field_(field),
        options_(options),
        progress_(progress),
        as_given_(std::move(as_given)),
        frame_(unit_frame::choose(d, field, !options.limit_size && !options.tolerance)),
        image_(frame_.inward(d)),
        framed_(field, frame_) {}

  result<mesh_outcome> run() {
    if (auto failure = measure_sites()) return *failure;
    // Without demands stars agree in most metrics that are the same everywhere. In one so thin that
    // they do not, thinness is what is in the way, and the metric is relaxed as any other: its
    // mean, computed in doubles, is a less thin one, and how much it differs is told.
    if (is_same_everywhere_) {
      if (is_final(attempt({relaxation_kind::without_demands, 1, 1, extent_}))) return conclude();
      is_same_everywhere_ = false;
      if (auto failure = measure_sites(false)) return *failure;
    }
    if (!as_given_.jumps)
      for (const double power : {0.7, 0.5})
        if (is_final(attempt({relaxation_kind::softened, power, 1, 1}))) return conclude();
    constexpr double part_of_domain = 1.0 / 16;
    double reach = options_.limit_size ? 1 : part_of_domain * extent_;
    for (const double beta : {1.5, 1.2}) {
      if (is_final(attempt({relaxation_kind::graded, 1, beta, reach}))) return conclude();
      if (crowded_) break;
      if (longer_edges_ <= reach) continue;
      reach = 2 * longer_edges_;  // fewer sites, and more for the slower metric
      if (is_final(attempt({relaxation_kind::graded, 1, beta, reach}))) return conclude();
    }
    for (const auto kind : {relaxation_kind::constant, relaxation_kind::without_demands})
      if (is_final(attempt({kind, 1, 1, extent_}))) return conclude();
    return std::move(as_given_);
  }

 private:
  // The mean of the metric and the extent of the domain in it, both in the frame.
  std::optional<error> measure_sites(bool may_be_constant = true) {
    std::vector<metric_tensor> tensors;
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

  // Whether sites and places of a lattice over the box all have this tensor, bit for bit: then
  // another metric would not help, and what is in the way is the domain or a limit.
  bool is_same_at_all_places(const metric_tensor& one,
                             const std::vector<metric_tensor>& at_sites) const {
    if (std::any_of(at_sites.begin(), at_sites.end(),
                    [&one](const metric_tensor& m) { return !(m == one); }))
      return false;
    constexpr int lattice = 24;
    const bounding_box box = image_.box();
    for (int i = 0; i < lattice * lattice; ++i) {
      const double u = (i % lattice + 0.5) / lattice, v = (i / lattice + 0.5) / lattice;
      const auto there =
          framed_.at({(1 - u) * box.low.x + u * box.high.x, (1 - v) * box.low.y + v * box.high.y});
      if (there && !(there.value() == one)) return false;
    }
    return true;
  }

  // Empty where it cannot be made, or is what has been meshed already.
  std::unique_ptr<metric_field> make_field() const {
    std::unique_ptr<metric_field> made;
    if (step_.kind == relaxation_kind::softened)
      made = soften(framed_, step_.power);
    else if (step_.kind == relaxation_kind::graded)
      made = grade_over(framed_, image_.box(), step_.beta, step_.reach, mean_,
                        [this] { return options_.stop && options_.stop(); });
    else
      made = same_everywhere(mean_);
    return made ? seen_from_outside(std::move(made), frame_) : nullptr;
  }

  // Whether an edge of length 1 ends, at many places of a lattice over the box, where lengths are
  // measured quite otherwise: a forecast that spares fills in which every site meets all others.
  // Where the metric turns by a radian over an edge this is 2.8, and 1.6 where such a metric is
  // softened enough.
  bool varies_too_fast(const metric_field& relaxed) const {
    constexpr int lattice = 24;
    constexpr double too_much = 3, part = 0.1;
    const framed_field field(relaxed, frame_);
    const bounding_box box = image_.box();
    int asked = 0, beyond = 0;
    for (int i = 0; i < lattice * lattice; ++i) {
      const int row = i / lattice, column = i % lattice;
      const double u = (column + 0.5) / lattice, v = (row + 0.5) / lattice;
      const point q{box.low.x + u * (box.high.x - box.low.x),
                    box.low.y + v * (box.high.y - box.low.y)};
      const auto here = field.at(q);
      if (!here) continue;
      const unit_displacements unit = unit_circle(here.value());
      for (const point& e : {unit.first, unit.second}) {
        const auto there = field.at({q.x + e.x, q.y + e.y});
        if (!there) continue;
        ++asked;
        if (distortion(here.value(), there.value()) > too_much) ++beyond;
      }
    }
    return beyond > part * asked;
  }

  // Leaves what came of it in tried_; nothing where sites cannot be spread, or edges will be longer
  // than the field was made for.
  const std::optional<mesh_outcome>& attempt(const relaxation_step& step) {
    step_ = step;
    tried_.reset();
    crowded_ = false;
    longer_edges_ = 1;
    if (is_stopped()) return tried_;
    mesh_options options = options_;
    if (step.kind == relaxation_kind::without_demands) {
      options.angle_bound = 0;
      options.limit_size = false;
    }
    const auto relaxed = make_field();
    if (is_stopped() || !relaxed) return tried_;
    const bool may_vary =
        step.kind == relaxation_kind::softened || step.kind == relaxation_kind::graded;
    crowded_ = options.limit_size && may_vary && varies_too_fast(*relaxed);
    if (crowded_) return tried_;
    const auto filled = fill_within_budget(frame_, domain_, *relaxed, options, progress_);
    if (!filled || (filled.value().proposed.stopped && is_stopped())) return tried_;
    crowded_ = filled.value().proposed.crowded.has_value();
    longer_edges_ = std::exp2(filled.value().halvings / 2.0);
    if (crowded_ || (may_vary && longer_edges_ > step.reach)) return tried_;
    refine(filled.value(), *relaxed, options);
    return tried_;
  }

  void refine(const budgeted_filling& filled, const metric_field& relaxed,
              const mesh_options& options) {
    ++tries_;
    const auto own_kernel = kernel_.fork();  // the work done for one mesh is counted from zero
    auto made = mesh_from_sites(filled, *own_kernel, domain_, relaxed, options, progress_);
    kernel_.count(own_kernel->counters());
    if (made) tried_ = std::move(made).value();
  }

  bool is_stopped() {
    if (!stopped_ && options_.stop) stopped_ = options_.stop();
    return stopped_.has_value();
  }

  bool is_final(const std::optional<mesh_outcome>& tried) const {
    if (stopped_) return true;
    if (!tried) return false;
    const bool agrees = tried->disagreeing == 0 && tried->stars_missing == 0 && !tried->crowded;
    return agrees || tried->stopped;
  }

  result<mesh_outcome> conclude() {
    if (stopped_ || tried_->stopped) {
      as_given_.stopped = true;
      as_given_.reason = (stopped_ ? "stopped: " + *stopped_ : tried_->reason) +
                         ", in the metric relaxed; before that, in the metric given, " +
                         as_given_.reason;
      return std::move(as_given_);
    }
    relaxation_report report;
    report.why = as_given_.reason;
    report.kind = step_.kind;
    report.power = step_.power;
    report.beta = step_.beta;
    report.reach = frame_.length_outward(step_.reach);
    report.tries = tries_;
    if (auto failure = compare(report)) return *failure;
    judge(report);
    if (auto fitted = fit_to_given(report)) return *std::move(fitted);
    if (step_.kind == relaxation_kind::without_demands) tried_->complete = false;
    tried_->complete = tried_->complete && report.low_triangles.empty();
    tried_->reason = reason(report);
    tried_->relaxed = std::move(report);
    return *std::move(tried_);
  }

  // The mesh fitted to the metric given, if the auditor then certifies it there. Aims differ in
  // what comes of them by little, which may be what is missing.
  std::optional<mesh_outcome> fit_to_given(const relaxation_report& report) {
    if (step_.kind != relaxation_kind::softened || !tried_->complete ||
        report.low_triangles.empty())
      return std::nullopt;
    for (const double aim : {4.5, 6.0, 3.5}) {
      fitting_options wanted;
      wanted.angle_bound = options_.angle_bound;
      wanted.degrees_above_bound = aim;
      if (options_.stop) wanted.enough = [this] { return options_.stop().has_value(); };
      const auto fitted = fit(domain_, field_, tried_->result, wanted);
      if (fitted && fitted.value().stopped) fitting_stopped_ = options_.stop();
      if (!fitted || fitted.value().stopped) return std::nullopt;
      constexpr std::size_t hopeless = 50;
      if (fitted.value().low > hopeless) return std::nullopt;
      if (fitted.value().low > 0) continue;
      audit_options options;
      options.angle_bound = options_.angle_bound;
      options.find_exempt_corners = true;
      options.original = &domain_;
      const audit_report found = audit(fitted.value().triangulation, options);
      if (found.certified) return outcome_of(fitted.value(), found, report);
    }
    return std::nullopt;
  }

  mesh_outcome outcome_of(const fitted_domain& fitted, const audit_report& found,
                          const relaxation_report& report) const {
    mesh_outcome o;
    o.complete = true;
    o.result = fitted.triangulation;
    o.tolerance = tried_->tolerance;
    o.sites = o.result.sites.size();
    o.triangles = o.result.triangles.size();
    o.splits = o.result.boundary.size() - domain_.segments.size();
    o.inserted = o.sites - domain_.vertices.size() - o.splits;
    o.length_factor = tried_->length_factor;
    for (const vertex_index v : found.exempt_corners)
      o.exempt.push_back({v, angle_at(o.result, v)});
    for (const vertex_index t : found.exempt_triangles)
      o.exempt_triangles.push_back(o.result.triangles[t]);
    if (options_.limit_size) o.too_large = count_large(o.result);
    o.fitted = fitting_report{as_given_.reason, report.power,     report.low_triangles.size(),
                              fitted.rounds,    fitted.moves,     fitted.flips,
                              fitted.collapses, fitted.insertions};
    o.reason = fmt::format(
        "all stars agree and every triangle meets the bound, since the mesh of the metric with "
        "aspects to the power of {} was fitted to the one given; {} triangles are larger than the "
        "size asks for (before: {})",
        report.power, o.too_large, as_given_.reason);
    return o;
  }

  // Between two subsegments at v, the smallest, as v measures it.
  static double angle_at(const mesh& m, vertex_index v) {
    double least = 180;
    for (const boundary_edge& leaving : m.boundary)
      for (const boundary_edge& entering : m.boundary) {
        if (leaving.a != v || entering.b != v) continue;
        const point &o = m.sites[v].position, &p = m.sites[leaving.b].position,
                    &q = m.sites[entering.a].position;
        if ((p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x) > 0)
          least = std::min(least, corner_angle(m.sites[v], p, q));
      }
    return least;
  }

  static std::size_t count_large(const mesh& m) {
    return static_cast<std::size_t>(
        std::count_if(m.triangles.begin(), m.triangles.end(), [&m](const triangle& t) {
          return metric_circumradius({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]}) >
                 largest_circumradius;
        }));
  }

  // The sites' own tensors with those the field gives.
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

  // The angles in the metric given, by the auditor's exact test.
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

  static std::string metric_text(const relaxation_report& report) {
    switch (report.kind) {
      case relaxation_kind::softened:
        return fmt::format("the metric with aspects to the power of {}", report.power);
      case relaxation_kind::graded:
        return fmt::format("the metric graded with {} over the length {:.4g}", report.beta,
                           report.reach);
      case relaxation_kind::constant:
        return "one metric for all";
      case relaxation_kind::without_demands:
        break;
    }
    return "one metric for all, with no demands on angles and sizes";
  }

  // The metric is not to blame: what is, is a limit, which `why` names, or details of the domain
  // far smaller than the rest, near which the shortest edge is.
  std::string reason_without_relaxation(const relaxation_report& report) const {
    const auto [length, at] = shortest_edge(tried_->result);
    return fmt::format(
        "no mesh was found that meets the demands ({}), though the metric is the same everywhere; "
        "the one delivered is made with no demands on angles and sizes, and its shortest edge, "
        "{:.4g} "
        "long, is at ({}, {}): {}; {} triangles are below {} degrees{}",
        report.why, length, format_number(at.x), format_number(at.y), tried_->reason,
        report.low_triangles.size(), options_.angle_bound, worst_text(report));
  }

  // As its first end measures it, and that end.
  static std::pair<double, point> shortest_edge(const mesh& m) {
    std::pair<double, point> least{std::numeric_limits<double>::infinity(), {}};
    for (const triangle& t : m.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const site &p = m.sites[t[i]], &q = m.sites[t[(i + 1) % 3]];
        const double length = std::sqrt(squared_distance(p, q.position));
        if (length < least.first) least = {length, p.position};
      }
    return least;
  }

  // Nothing where no triangle is away from the exempt corners.
  static std::string worst_text(const relaxation_report& report) {
    return report.worst_angle < 180 ? fmt::format(", the worst {:.2f}", report.worst_angle) : "";
  }

  std::string reason(const relaxation_report& report) const {
    if (is_same_everywhere_) return reason_without_relaxation(report);
    const std::string stopped =
        fitting_stopped_ ? "; fitting it to that was stopped: " + *fitting_stopped_ : "";
    return fmt::format(
        "stars cannot agree in the metric given ({}); they agree in {}, which differs from it at "
        "{} of {} sites, with lengths up to {:.4g} times as long and {:.4g} times as short: {}; as "
        "the metric given measures them {} triangles are below {} degrees{}{}",
        report.why, metric_text(report), report.changed, report.given.size(), report.most_longer,
        report.most_shorter, tried_->reason, report.low_triangles.size(), options_.angle_bound,
        worst_text(report), stopped);
  }

  const star_predicates& kernel_;
  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  const std::function<void(const mesh_progress&)>& progress_;
  mesh_outcome as_given_;
  unit_frame frame_;
  domain image_;  // in the frame, as all that follows
  framed_field framed_;
  metric_tensor mean_;
  bool is_same_everywhere_ = false;
  double extent_ = 0;
  std::optional<mesh_outcome> tried_;
  relaxation_step step_;                        // of the last attempt, as what follows
  std::optional<std::string> stopped_;          // why, between meshes
  std::optional<std::string> fitting_stopped_;  // why, while fitting
  bool crowded_ = false;
  double longer_edges_ = 1;
  std::size_t tries_ = 0;
};

}  // namespace

bool wants_relaxation(const mesh_outcome& made, const mesh_options& options) {
  return options.relax && options.strategy == refinement_strategy::fill && !made.stopped &&
         !made.complete && (made.disagreeing > 0 || made.stars_missing > 0 || made.crowded);
}

result<mesh_outcome> refine_relaxed(const star_predicates& kernel, const domain& d,
                                    const metric_field& field, const mesh_options& options,
                                    const std::function<void(const mesh_progress&)>& progress,
                                    mesh_outcome as_given) {
  return relaxation(kernel, d, field, options, progress, std::move(as_given)).run();
}

}  // namespace asterism::internal
