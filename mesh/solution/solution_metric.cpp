// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/solution_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/solution/computed_field.hpp"
#include "asterism/mesh/solution/field_derivatives.hpp"
#include "asterism/mesh/solution/metric_maker.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"
#include "asterism/mesh/solution/relative_error.hpp"

namespace asterism {
using namespace internal;
namespace {

using failure = std::optional<error>;

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
  report.share_noise = share_of(found.noise, all);
  report.share_at_boundary = share_of(found.at_boundary, all);
  report.share_floored = share_of(optima.floored, all);
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

// Makes the metric of the fields. Lowers the least density while places at that density would take
// clearly more than usual_floor_share of the complexity, as they do where least sizes use up
// complexity. Adjusts the bound of the longest edge until that edge is about as long as the domain,
// each time by half of the deviation in logarithms: with an error wanted, the factor of the metric
// falls as that edge grows.
result<solution_metric> metric_of(const field_derivatives& found, metric_maker& maker,
                                  const solution_metric_options& options) {
  constexpr int most_rounds = 5;
  constexpr double tolerable_times = 1.5;
  const double extent = maker.extent(), longest = extent * extent;
  optimum_bounds bounds{usual_floor_share,
                        1 / longest / first_complexity(options, maker),
                        {maker.sides()[0] / extent, maker.sides()[1] / extent}};
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
  maker.set_recovered(found.value().recovered, found.value().powers, false);
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
  maker.set_recovered(found.value().recovered, found.value().powers, true);
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
