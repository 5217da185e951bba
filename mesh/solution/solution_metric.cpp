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
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/graph_gradation.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "asterism/mesh/solution/mean_moduli.hpp"
#include "asterism/mesh/solution/metric_bounds.hpp"
#include "asterism/mesh/solution/metric_steps.hpp"
#include "asterism/mesh/solution/nodal_sums.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"

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

// Steps 4 to 8, for any factor.
class metric_maker {
 public:
  metric_maker(const mesh& m, const solution_metric_options& options,
               const std::vector<tensors>& intersected)
      : mesh_(m),
        options_(options),
        others_(intersected),
        links_(m),
        areas_(nodal_areas(m, links_)) {}

  const std::vector<double>& areas() const { return areas_; }
  const mesh_links& links() const { return links_; }
  solution_metric_report& report() { return report_; }
  void set_raw(tensors raw) { raw_ = std::move(raw); }
  // The metric keeps its own complexity unless one is asked for.
  void set_given(tensors given) {
    raw_ = std::move(given);
    is_given_ = true;
  }
  void set_absolute(std::vector<tensors> absolute) { absolute_ = std::move(absolute); }
  failure set_implied();
  result<solution_metric> run();

 private:
  tensors shaped(double factor);
  tensors graded(tensors t);
  void note_marks(const std::vector<std::uint8_t>& marks);
  double error_of(const tensors& t) const;
  double measure(double factor);
  void meet(double target);
  void say(double target, double got);

  const mesh& mesh_;
  const solution_metric_options& options_;
  const std::vector<tensors>& others_;
  mesh_links links_;
  std::vector<double> areas_;
  bool is_given_ = false;
  tensors raw_, implied_, made_;
  std::vector<tensors> absolute_;
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

tensors metric_maker::shaped(double factor) {
  const size_bounds bounds{options_.least_size, options_.greatest_size, options_.aspect};
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
  for (const tensors& h : absolute_)
    greatest = std::max(greatest, predicted_error(t, h, areas_, options_.norm));
  return greatest;
}

// Makes the metric of this factor. Returns what is to meet the target, which grows with the factor.
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
  // About what it takes without bounds.
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
      if (y - x < 1e-12) break;
      factor = elementary::exp(x + part * (y - x));
    } else {
      // Saturated: even sixteen to the sixth times as much changes nothing any more.
      saturated = step > 0 && std::abs(got - before) <= 1e-9 * got ? saturated + 1 : 0;
      if (saturated == 6) break;
      // A little more than would do if the measure grew as the factor does; sixteen times once that
      // has not led past the target.
      const double ratio = std::clamp(target / got, 1.0 / 16, 16.0);
      factor *= step < 3 ? ratio * (ratio > 1 ? 1.1 : 0.9) : got < target ? 16 : 1.0 / 16;
      if (!(factor > 1e-280 && factor < 1e280)) break;
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
  if (!too_few) add(report_.share_greatest_size, "hmax");
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
  if (auto failed = set_implied()) return *failed;
  report_.steps = metric_steps(options_, absolute_.size(), others_.size());
  for (const tensors& other : others_)
    if (other.size() != mesh_.sites.size())
      return error{fmt::format("{} tensors to intersect with, for {} vertices", other.size(),
                               mesh_.sites.size())};
  if (is_given_ && !options_.vertices && !options_.complexity) {
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
    return error{fmt::format("vertex {}: the metric made is {} {} {}, not finite and positive "
                             "definite",
                             v + 1, m.m11, m.m12, m.m22),
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

failure check_mesh(const mesh& m) {
  if (m.sites.empty() || m.triangles.empty()) return error{"the mesh has no triangle"};
  return {};
}

}  // namespace

result<solution_metric> make_solution_metric(const mesh& m, const std::vector<nodal_values>& fields,
                                             const solution_metric_options& options,
                                             const std::vector<tensors>& intersected) {
  if (auto failed = check(options)) return *failed;
  if (auto failed = check_mesh(m)) return *failed;
  if (fields.empty()) return error{"there is no field to make a metric of"};
  metric_maker maker(m, options, intersected);
  std::vector<const nodal_values*> sorted;
  sorted.reserve(fields.size());
  for (const nodal_values& f : fields) sorted.push_back(&f);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto* a, const auto* b) { return a->name < b->name; });
  tensors raw;
  std::vector<tensors> absolute;
  solution_metric_report& report = maker.report();
  std::size_t noise = 0, at_boundary = 0, floored = 0;
  for (const nodal_values* f : sorted) {
    auto hessian = recover_hessian(m, f->values, options.hessian);
    if (!hessian) return hessian.failure().at("field " + f->name);
    if (options.hessian == hessian_method::green)
      hessian.value().at = mean_moduli(m, maker.links(), hessian.value().at);
    auto own =
        make_optimal_metric(hessian.value().at, maker.areas(), options.norm, options.isotropic);
    report.fields.push_back(f->name);
    report.flat_fields += own.is_flat ? 1 : 0;
    noise += hessian.value().noise;
    at_boundary += hessian.value().at_boundary;
    floored += own.floored;
    absolute.push_back(std::move(own.absolute));
    if (raw.empty()) {
      raw = std::move(own.tensors);
    } else {
      for_each_node(raw.size(), [&](std::size_t v) {
        raw[v] = simultaneous_intersection(raw[v], own.tensors[v]);
      });
    }
  }
  const std::size_t all = sorted.size() * m.sites.size();
  report.share_noise = share(noise, all);
  report.share_at_boundary = share(at_boundary, all);
  report.share_floored = share(floored, all);
  if (options.error && report.flat_fields == sorted.size())
    return error{
        "the fields have no second derivatives: any mesh has an error of 0, and none is "
        "best",
        error_code::bad_option};
  maker.set_raw(std::move(raw));
  maker.set_absolute(std::move(absolute));
  return maker.run();
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
