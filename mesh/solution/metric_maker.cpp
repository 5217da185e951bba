// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/metric_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/gradation/graph_gradation.hpp"
#include "asterism/mesh/numerics/metric_bounds.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/numerics/target_search.hpp"
#include "asterism/mesh/solution/implied_metric.hpp"
#include "asterism/mesh/solution/metric_steps.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

constexpr double tolerable = 0.02;  // of the target

// Returns the sides of the box around the sites.
std::array<double, 2> sides_of(const mesh& m) {
  const bounding_box box = box_of_sites(m.sites);
  return {box.high.x - box.low.x, box.high.y - box.low.y};
}

}  // namespace

metric_maker::metric_maker(const mesh& m, const solution_metric_options& options,
                           const std::vector<tensors>& intersected)
    : mesh_(m),
      options_(options),
      others_(intersected),
      links_(m),
      areas_(nodal_areas(m, links_)),
      sides_(sides_of(m)) {}

std::optional<error> metric_maker::set_implied() {
  if (!options_.step) return {};
  auto found = implied_metric(mesh_);
  if (!found) return found.failure();
  implied_ = std::move(found).value();
  return {};
}

void metric_maker::note_marks(const std::vector<std::uint8_t>& marks) {
  const auto part = [&](clipped what) {
    return share_of(
        static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(),
                                               [&](std::uint8_t m) { return (m & what) != 0; })),
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
  return std::min(options_.greatest_size, times * extent());
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
  report_.share_graded = share_of(done.changed, t.size());
  report_.gradation_rounds = done.rounds;
  report_.gradation_ended = done.ended;
  return t;
}

double metric_maker::error_of(const tensors& t) const {
  double greatest = 0;
  for (std::size_t k = 0; k < recovered_.size(); ++k)
    greatest =
        std::max(greatest,
                 std::scalbn(predicted_error(t, recovered_[k], areas_, options_.norm), powers_[k]));
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
  return error > 0 ? 1 / error : infinity;
}

// Finds the factor. Begins with about the one that is right without bounds, and ends where the
// bounds allow no other result, or the result jumps.
void metric_maker::meet(double target) {
  const double close = options_.gradation ? 0.008 : 0.002;
  constexpr int most_steps = 60;
  constexpr double narrowest = 1e-12;  // of the factor, relative: the result jumps within
  // Limits of the factor: within the range of doubles, for products with tensors, and relative to
  // the first, for targets that no mesh meets.
  constexpr double least = 1e-280, most = 1e280, farthest = 1e72;
  const double first = (options_.error ? static_cast<double>(mesh_.sites.size()) : target) /
                       complexity_of(raw_, areas_);
  const auto off = [&](double got) { return elementary::log(got / target); };
  target_search search;
  double factor = first, got = measure(first);
  for (int step = 0; step < most_steps && std::abs(off(got)) > close; ++step) {
    search.take(off(got));
    const double within = std::clamp(elementary::exp(search.at()), 1 / farthest, farthest) * first;
    const double next = std::clamp(within, least, most);
    if (search.is_saturated() || search.width() < narrowest || next == factor) break;
    factor = next;
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
      "{} {:.6g} was wanted, and the bounds allow {} {:.6g}, for any factor{}",
      options_.error ? "an error of" : "a complexity of", options_.error ? 1 / target : target,
      options_.error == std::nullopt ? (too_few ? "no more than" : "no less than")
                                     : (too_few ? "no less than" : "no more than"),
      options_.error ? 1 / got : got, limits.empty() ? "" : ": " + limits + " of the vertices");
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

}  // namespace asterism::internal
