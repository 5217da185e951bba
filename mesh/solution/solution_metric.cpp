// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/solution_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/numerics/metric_bounds.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/computed_field.hpp"
#include "asterism/mesh/solution/field_derivatives.hpp"
#include "asterism/mesh/solution/graph_gradation.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "asterism/mesh/solution/metric_steps.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"
#include "asterism/mesh/solution/relative_error.hpp"

namespace asterism {
using namespace internal;
namespace {

using tensors = std::vector<metric_tensor>;
using failure = std::optional<error>;

constexpr double vertices_of_unit = 2 / std::numbers::sqrt3;
constexpr double tolerable = 0.02;  // of the target

failure check(const solution_metric_options& o) {
  const auto bad = [](const std::string& what) { return error{what, error_code::bad_option}; };
  for (const auto& target : {o.vertices, o.complexity, o.error})
    if (target && !(*target > 0 && std::isfinite(*target)))
      return bad(fmt::format("a target must be positive, not {}", *target));
  if (o.vertices.has_value() + o.complexity.has_value() + o.error.has_value() > 1)
    return bad("one of vertices, complexity and error can be wanted, not several");
  if (o.relative && !o.error) return bad("a relative error is wanted, and no error is named");
  if (o.cutoff && !o.relative) return bad("a cutoff is of a relative error, and none is wanted");
  if (o.cutoff && !(*o.cutoff > 0 && *o.cutoff <= 1))
    return bad(fmt::format("the cutoff must be above 0 and at most 1, not {}", *o.cutoff));
  if (o.norm && !(*o.norm >= 1 && *o.norm <= 1e6))
    return bad(fmt::format("the norm must be from 1 to 1e6, or infinity, not {}", *o.norm));
  if (!(o.least_size >= 0) || !(o.greatest_size > o.least_size))
    return bad(fmt::format("sizes from {} to {}: the first must be less, and not negative",
                           o.least_size, o.greatest_size));
  if (!(o.aspect >= 1 && o.aspect <= 1e6))
    return bad(fmt::format("the aspect must be from 1 to 1e6, not {}", o.aspect));
  if (o.gradation && !(*o.gradation > 1 && *o.gradation <= 1e100))
    return bad(fmt::format("the gradation must be above 1, not {}", *o.gradation));
  if (o.step && !(*o.step > 1 && std::isfinite(*o.step)))
    return bad(fmt::format("the step must be above 1, not {}", *o.step));
  return {};
}

double share(std::size_t part, std::size_t of) {
  return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
}

// Returns the longer side of the box around the sites.
double extent_of(const mesh& m) {
  point low = m.sites.front().position, high = low;
  for (const site& s : m.sites) {
    low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y)};
    high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

// Makes steps 4 to 8 of the metric for any factor.
class metric_maker {
 public:
  metric_maker(const mesh& m, const solution_metric_options& options,
               const std::vector<tensors>& intersected)
      : mesh_(m),
        options_(options),
        others_(intersected),
        links_(m),
        areas_(nodal_areas(m, links_)),
        extent_(extent_of(m)) {}

  const std::vector<double>& areas() const { return areas_; }
  double extent() const { return extent_; }
  const mesh_links& links() const { return links_; }
  solution_metric_report& report() { return report_; }
  void set_raw(tensors raw) { raw_ = std::move(raw); }
  // Sets the complexity wanted to the metric's own unless one is asked for.
  void set_given(tensors given) {
    raw_ = std::move(given);
    is_given_ = true;
  }
  void set_layers(std::optional<double> aspect) { layers_ = aspect; }
  void set_recovered(std::vector<tensors> recovered, bool are_given) {
    recovered_ = std::move(recovered);
    hessians_given_ = are_given;
  }
  failure set_implied();
  result<solution_metric> run();

 private:
  tensors shaped(double factor);
  tensors graded(tensors t);
  void note_marks(const std::vector<std::uint8_t>& marks);
  double greatest_size() const;
  double error_of(const tensors& t) const;
  double measure(double factor);
  void meet(double target);
  void say(double target, double got);

  const mesh& mesh_;
  const solution_metric_options& options_;
  const std::vector<tensors>& others_;
  mesh_links links_;
  std::vector<double> areas_;
  double extent_;
  bool is_given_ = false, hessians_given_ = false;
  tensors raw_, implied_, made_;
  std::vector<tensors> recovered_;
  std::optional<double> layers_;  // bound on aspects of fields that were computed
  solution_metric_report report_;
};

failure metric_maker::set_implied() {
  if (!options_.step) return {};
  auto found = implied_metric(mesh_);
  if (!found) return found.failure();
  implied_ = std::move(found).value();
  return {};
}

void metric_maker::note_marks(const std::vector<std::uint8_t>& marks) {
  const auto part = [&](clipped what) {
    return share(static_cast<std::size_t>(std::count_if(
                     marks.begin(), marks.end(), [&](std::uint8_t m) { return (m & what) != 0; })),
                 marks.size());
  };
  report_.share_least_size = part(clipped_by_least);
  report_.share_greatest_size = part(clipped_by_greatest);
  report_.share_aspect = part(clipped_by_aspect);
  report_.share_step = part(clipped_by_step);
  report_.share_intersected = part(clipped_by_intersection);
}

// Returns hmax, or a thousand times the extent of the mesh: greater sizes make the same triangles,
// and their tensors lose digits. A given metric stays as it is.
double metric_maker::greatest_size() const {
  constexpr double times = 1000;
  if (is_given_ && !options_.vertices && !options_.complexity) return options_.greatest_size;
  return std::min(options_.greatest_size, times * extent_);
}

tensors metric_maker::shaped(double factor) {
  const size_bounds bounds{options_.least_size, greatest_size(), options_.aspect};
  tensors made(raw_.size());
  std::vector<std::uint8_t> marks(raw_.size(), 0);
  for_each_node(raw_.size(), [&](std::size_t v) {
    metric_tensor m{factor * raw_[v].m11, factor * raw_[v].m12, factor * raw_[v].m22};
    for (const tensors& other : others_) {
      const metric_tensor both = simultaneous_intersection(m, other[v]);
      if (!identical(both, m)) marks[v] |= clipped_by_intersection;
      m = both;
    }
    if (options_.step) m = step_limited(m, implied_[v], *options_.step, marks[v]);
    made[v] = bounded(m, bounds, marks[v]);
  });
  note_marks(marks);
  return made;
}

tensors metric_maker::graded(tensors t) {
  report_.complexity_before_gradation = complexity_of(t, areas_);
  if (!options_.gradation) return t;
  const auto done = grade_on_graph(
      mesh_, links_, *options_.gradation,
      options_.gradation_keeps_shape ? gradation_space::metric : gradation_space::mixed, t);
  report_.share_graded = share(done.changed, t.size());
  report_.gradation_rounds = done.rounds;
  report_.gradation_ended = done.ended;
  return t;
}

double metric_maker::error_of(const tensors& t) const {
  double greatest = 0;
  for (const tensors& h : recovered_)
    greatest = std::max(greatest, predicted_error(t, h, areas_, options_.norm));
  return greatest;
}

// Makes the metric of this factor. Returns the quantity that is to meet the target; it grows with
// the factor.
double metric_maker::measure(double factor) {
  made_ = graded(shaped(factor));
  report_.factor = factor;
  report_.complexity_delivered = complexity_of(made_, areas_);
  if (!options_.error) return report_.complexity_delivered;
  const double error = error_of(made_);
  return error > 0 ? 1 / error : std::numeric_limits<double>::infinity();
}

// Finds the factor: steps by 16 until the target lies between two factors, then the secant in
// logarithms, or half the interval where the secant leaves it or hardly narrows it.
void metric_maker::meet(double target) {
  const double close = options_.gradation ? 0.008 : 0.002;
  constexpr int most_steps = 60;
  const auto off = [&](double got) { return elementary::log(got / target); };
  double low = 0, high = 0, low_off = 0, high_off = 0;
  // Begins with about the factor that is right without bounds.
  double factor = (options_.error ? static_cast<double>(mesh_.sites.size()) : target) /
                  complexity_of(raw_, areas_);
  int saturated = 0;
  double got = measure(factor), before = 0;
  for (int step = 0; step < most_steps && std::abs(off(got)) > close; ++step) {
    (got < target ? low : high) = factor;
    (got < target ? low_off : high_off) = off(got);
    if (low > 0 && high > 0) {
      const double x = elementary::log(low), y = elementary::log(high);
      double part = -low_off / (high_off - low_off);
      if (!(part > 0.02 && part < 0.98) || step % 4 == 3) part = 0.5;
      constexpr double narrowest = 1e-12;  // of the factor: the measure jumps between the two
      if (y - x < narrowest) break;
      factor = elementary::exp(x + part * (y - x));
    } else {
      // Tolerance of a saturated quantity: even sixteen to the sixth times the factor changes
      // nothing any more.
      constexpr double alike = 1e-9;  // far below the 2e-3 to which the target is met
      saturated = step > 0 && std::abs(got - before) <= alike * got ? saturated + 1 : 0;
      if (saturated == 6) break;
      // Takes a little more than would suffice if the quantity grew with the factor; sixteen times
      // once that did not pass the target.
      const double ratio = std::clamp(target / got, 1.0 / 16, 16.0);
      factor *= step < 3 ? ratio * (ratio > 1 ? 1.1 : 0.9) : got < target ? 16 : 1.0 / 16;
      // Ends near the range of doubles, before products with tensors exceed it.
      constexpr double least = 1e-280, most = 1e280;
      if (!(factor > least && factor < most)) break;
    }
    before = got;
    got = measure(factor);
  }
  say(target, got);
}

void metric_maker::say(double target, double got) {
  report_.reached = std::abs(got / target - 1) <= tolerable;
  if (report_.reached) return;
  const bool too_few = got < target;
  std::string limits;
  const auto add = [&](double part, const char* what) {
    if (part > 0)
      limits += (limits.empty() ? "" : ", ") + fmt::format("{} at {:.0f} %", what, 100 * part);
  };
  if (too_few) add(report_.share_least_size, "hmin");
  const bool is_named = options_.greatest_size <= greatest_size();
  if (!too_few)
    add(report_.share_greatest_size,
        is_named ? "hmax" : "sizes of a thousand times the mesh's extent");
  add(report_.share_aspect, "the aspect");
  add(report_.share_step, "the step");
  add(report_.share_intersected, "metrics intersected");
  if (!too_few) add(report_.share_graded, "gradation");
  report_.reason = fmt::format(
      "{} {:.6g} was wanted, and the bounds allow {} {:.6g}, for any factor: {} of the vertices",
      options_.error ? "an error of" : "a complexity of", options_.error ? 1 / target : target,
      options_.error == std::nullopt ? (too_few ? "no more than" : "no less than")
                                     : (too_few ? "no less than" : "no more than"),
      options_.error ? 1 / got : got, limits.empty() ? "nothing bound" : limits);
}

result<solution_metric> metric_maker::run() {
  if (implied_.empty())
    if (auto failed = set_implied()) return *failed;
  report_.steps =
      metric_steps(options_, recovered_.size(), others_.size(), hessians_given_, layers_);
  for (const tensors& other : others_)
    if (other.size() != mesh_.sites.size())
      return error{fmt::format("{} tensors to intersect with, for {} vertices", other.size(),
                               mesh_.sites.size())};
  const bool has_scale = is_given_ && !options_.vertices && !options_.complexity;
  if (has_scale || options_.relative) {
    measure(1);
    report_.reached = true;
  } else if (options_.error) {
    meet(1 / *options_.error);
  } else {
    const double vertices = options_.vertices.value_or(static_cast<double>(mesh_.sites.size()));
    report_.complexity_asked = options_.complexity.value_or(vertices / vertices_of_unit);
    meet(report_.complexity_asked);
  }
  report_.error_predicted = error_of(made_);
  const filtered_kernel kernel;
  for (std::size_t v = 0; v < made_.size(); ++v) {
    const metric_tensor& m = made_[v];
    const bool is_finite = std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22);
    if (is_finite && kernel.is_positive_definite(m)) continue;
    return error{
        fmt::format(
            "vertex {}: the metric made is not finite and positive definite: coordinates, "
            "values or the metric given are so large or so small that products of them have "
            "no double; give them in other units",
            v + 1),
        error_code::invalid_metric};
  }
  return solution_metric{std::move(made_), std::move(report_)};
}

// Returns tensors with the greater eigenvalue in all directions.
tensors rounded(const tensors& given) {
  tensors made(given.size());
  for_each_node(given.size(), [&](std::size_t v) {
    const double strong = eigen_of(given[v]).first;
    made[v] = {strong, 0, strong};
  });
  return made;
}

// Intersects the optimal metrics of the fields.
struct optimum {
  tensors raw;
  std::size_t flat = 0, floored = 0;
  double flat_part = 0, ridge_part = 0;  // of the complexity, the greatest of the fields
};

// Adds the metric of one more field.
void intersect(tensors own, tensors& all) {
  if (all.empty()) {
    all = std::move(own);
    return;
  }
  for_each_node(all.size(),
                [&](std::size_t v) { all[v] = simultaneous_intersection(all[v], own[v]); });
}

// Bounds the aspects of the metric of a field that was computed.
void bound_layers(const field_derivatives& found, std::size_t field, tensors& own) {
  if (field < found.aspects.size() && found.aspects[field])
    bound_aspects(*found.aspects[field], own);
}

// Returns the least of the bounds on aspects that computed fields ask for; none where no field
// does.
std::optional<double> least_aspect(const field_derivatives& found) {
  std::optional<double> least;
  for (const auto& one : found.aspects)
    if (one && !(least && *least <= *one)) least = one;
  return least;
}

optimum intersected_optima(const field_derivatives& found, const std::vector<double>& areas,
                           const solution_metric_options& options, const optimum_bounds& bounds) {
  optimum made;
  for (std::size_t k = 0; k < found.moduli.size(); ++k) {
    auto own = make_optimal_metric(found.moduli[k], areas, options.norm, options.isotropic, bounds);
    made.flat += own.is_flat ? 1 : 0;
    made.floored += own.floored;
    made.flat_part = std::max(made.flat_part, own.flat_part);
    made.ridge_part = std::max(made.ridge_part, own.ridge_part);
    bound_layers(found, k, own.tensors);
    intersect(std::move(own.tensors), made.raw);
  }
  return made;
}

bool is_zero(const metric_tensor& h) { return h.m11 == 0 && h.m12 == 0 && h.m22 == 0; }

// Intersects the metrics in which each field has the relative error. If all values of a field are
// equal, or all second derivatives zero, its metric is that of the greatest size.
optimum intersected_relative(const field_derivatives& found, const metric_maker& maker,
                             const solution_metric_options& options) {
  optimum made;
  for (std::size_t k = 0; k < found.moduli.size(); ++k) {
    const tensors& h = found.moduli[k];
    const bool is_flat = found.scales[k].empty() || std::all_of(h.begin(), h.end(), is_zero);
    made.flat += is_flat ? 1 : 0;
    auto own =
        relative_metric(h, found.scales[k], *options.error, maker.extent(), options.isotropic);
    bound_layers(found, k, own);
    intersect(std::move(own), made.raw);
  }
  return made;
}

error no_second_derivatives() {
  return {"the fields have no second derivatives: any mesh has an error of 0, and none is best",
          error_code::bad_option};
}

// Enters the known facts about the fields before their metric is made.
void report_fields(const field_derivatives& found, const optimum& optima,
                   solution_metric_report& report) {
  const std::size_t all = found.moduli.size() * found.moduli.front().size();
  report = {};
  report.fields = found.names;
  report.flat_fields = optima.flat;
  report.share_noise = share(found.noise, all);
  report.share_at_boundary = share(found.at_boundary, all);
  report.share_floored = share(optima.floored, all);
  report.complexity_at_least_density = optima.flat_part;
  report.complexity_along_ridges = optima.ridge_part;
}

result<solution_metric> relative_metric_of(const field_derivatives& found, metric_maker& maker,
                                           const solution_metric_options& options) {
  optimum made = intersected_relative(found, maker, options);
  if (made.flat == found.moduli.size()) return no_second_derivatives();
  report_fields(found, made, maker.report());
  maker.set_raw(std::move(made.raw));
  return maker.run();
}

// Returns the complexity to begin with: the one wanted, or that of the mesh.
double first_complexity(const solution_metric_options& options, const metric_maker& maker) {
  const auto has = static_cast<double>(maker.areas().size());
  return options.complexity.value_or(options.vertices.value_or(has) / vertices_of_unit);
}

// Makes the metric of the fields, with the least density at which all places that have it take the
// usual share of the complexity, and the longest edge as long as the domain. If least sizes take
// complexity away, the factor exceeds the resulting complexity, and so would that share: then the
// least density is lowered. The longest edge follows the factor by half of the way in logarithms:
// with an error wanted the factor falls as that edge grows.
result<solution_metric> metric_of(const field_derivatives& found, metric_maker& maker,
                                  const solution_metric_options& options) {
  constexpr int most_rounds = 5;
  constexpr double tolerable_times = 1.5;
  const double longest = maker.extent() * maker.extent();
  optimum_bounds bounds{usual_floor_share, 1 / longest / first_complexity(options, maker)};
  for (int round = 1;; ++round) {
    auto optima = intersected_optima(found, maker.areas(), options, bounds);
    if (options.error && optima.flat == found.moduli.size()) return no_second_derivatives();
    report_fields(found, optima, maker.report());
    maker.set_raw(std::move(optima.raw));
    auto made = maker.run();
    if (!made || !made.value().report.reached || round == most_rounds) return made;
    const solution_metric_report& report = made.value().report;
    const double times = report.factor * bounds.floor_share / usual_floor_share /
                         report.complexity_before_gradation,
                 long_times = report.factor * bounds.eigenvalue * longest;
    const bool is_too_long = optima.ridge_part > 0 &&
                             !(long_times < tolerable_times && long_times > 1 / tolerable_times);
    if (!(times > tolerable_times) && !is_too_long) return made;
    if (times > tolerable_times) bounds.floor_share /= times;
    bounds.eigenvalue /= std::sqrt(long_times);
  }
}

failure check_mesh(const mesh& m) {
  if (m.sites.empty() || m.triangles.empty()) return error{"the mesh has no triangle"};
  return {};
}

result<solution_metric> metric_of_values(const mesh& m, const glued_mesh* glued,
                                         const std::vector<nodal_values>& fields,
                                         const solution_metric_options& options,
                                         const std::vector<tensors>& intersected) {
  if (auto failed = check(options)) return *failed;
  if (auto failed = check_mesh(m)) return *failed;
  if (fields.empty()) return error{"there is no field to make a metric of"};
  solution_metric_options wishes = options;
  if (wishes.relative) wishes.norm.reset();
  metric_maker maker(m, wishes, intersected);
  const auto found = recovered_derivatives(m, maker.links(), fields, wishes, glued);
  if (!found) return found.failure();
  maker.set_recovered(found.value().recovered, false);
  maker.set_layers(least_aspect(found.value()));
  return wishes.relative ? relative_metric_of(found.value(), maker, wishes)
                         : metric_of(found.value(), maker, wishes);
}

}  // namespace

result<solution_metric> make_solution_metric(const mesh& m, const std::vector<nodal_values>& fields,
                                             const solution_metric_options& options,
                                             const std::vector<tensors>& intersected) {
  return metric_of_values(m, nullptr, fields, options, intersected);
}

result<solution_metric> make_glued_metric(const mesh& m, const glued_mesh& glued,
                                          const std::vector<nodal_values>& fields,
                                          const solution_metric_options& options,
                                          const std::vector<tensors>& intersected) {
  return metric_of_values(m, &glued, fields, options, intersected);
}

result<solution_metric> make_hessian_metric(const mesh& m, const std::vector<nodal_hessian>& fields,
                                            const solution_metric_options& options,
                                            const std::vector<tensors>& intersected) {
  if (auto failed = check(options)) return *failed;
  if (auto failed = check_mesh(m)) return *failed;
  if (options.relative)
    return error{
        "a relative error is of values, and second derivatives are given: divide them by "
        "what the error is to be a part of",
        error_code::bad_option};
  if (fields.empty()) return error{"there is no field to make a metric of"};
  metric_maker maker(m, options, intersected);
  const auto found = given_derivatives(m, fields);
  if (!found) return found.failure();
  maker.set_recovered(found.value().recovered, true);
  return metric_of(found.value(), maker, options);
}

result<solution_metric> shape_metric(const mesh& m, const tensors& given,
                                     const solution_metric_options& options,
                                     const std::vector<tensors>& intersected) {
  if (auto failed = check(options)) return *failed;
  if (auto failed = check_mesh(m)) return *failed;
  if (options.error) return error{"an error can be wanted of a solution alone"};
  if (given.size() != m.sites.size())
    return error{fmt::format("{} tensors for {} vertices", given.size(), m.sites.size())};
  metric_maker maker(m, options, intersected);
  maker.set_given(options.isotropic ? rounded(given) : given);
  return maker.run();
}

}  // namespace asterism
