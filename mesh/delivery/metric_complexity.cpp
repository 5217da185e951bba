// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/metric_complexity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/delivery/background.hpp"
#include "asterism/mesh/delivery/domain_background.hpp"
#include "asterism/mesh/gradation/graph_gradation.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {
namespace {

// Integrates the density over triangles, halving their sides where that changes the sum.
class density_integral {
 public:
  density_integral(const metric_field& field, double extent, const cancellation& stop)
      : field_(field), longest_(extent / 48), stop_(stop) {}

  result<double> over(const point& a, const point& b, const point& c) {
    failure_ = std::nullopt;
    const double sum = refined(a, b, c, coarse(a, b, c), 0);
    if (failure_) return *failure_;
    return sum;
  }

 private:
  double density(const point& q) {
    if (failure_) return 0;
    const auto there = field_.at(q);
    if (!there) failure_ = there.failure();
    return there ? plain_root_of_determinant(there.value()) : 0;
  }

  // Integrates over a triangle by the values at the middles of its sides, which is exact for
  // polynomials of degree two.
  double coarse(const point& a, const point& b, const point& c) {
    const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    return area / 3 * (density(middle(a, b)) + density(middle(b, c)) + density(middle(c, a)));
  }

  static point middle(const point& a, const point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

  static std::vector<point> middles_of(const std::array<std::array<point, 3>, 4>& triangles) {
    std::vector<point> places;
    for (const auto& [a, b, c] : triangles)
      places.insert(places.end(), {middle(a, b), middle(b, c), middle(c, a)});
    return places;
  }

  bool is_long(const point& a, const point& b) const {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) > longest_;
  }

  // Returns the integral over the triangle; `before` is the value of coarse() for the undivided
  // triangle. Long triangles are halved in any case, so that narrow features are found.
  double refined(const point& a, const point& b, const point& c, double before, int depth) {
    constexpr double slack = 2e-3;  // of a triangle's own part
    constexpr int deepest = 24;
    if (failure_) return 0;
    if (++asked_ % 1024 == 0 && stop_.is_requested())
      failure_ = error{"stopped while the complexity of the metric was being measured"};
    const point p = middle(b, c), q = middle(c, a), r = middle(a, b);
    const std::array<std::array<point, 3>, 4> parts = {
        {{a, r, q}, {r, b, p}, {q, p, c}, {p, q, r}}};
    std::array<double, 4> each{};
    double sum = 0;
    field_.expect([&parts] { return middles_of(parts); });
    for (std::size_t i = 0; i < 4; ++i)
      sum += each[i] = coarse(parts[i][0], parts[i][1], parts[i][2]);
    const bool is_fine = !is_long(a, b) && !is_long(b, c) && !is_long(c, a);
    if (is_fine && (std::abs(sum - before) <= slack * sum || sum < smallest_part_)) return sum;
    if (depth >= deepest || asked_ > most_) return sum;
    double finer = 0;
    for (std::size_t i = 0; i < 4; ++i)
      finer += refined(parts[i][0], parts[i][1], parts[i][2], each[i], depth + 1);
    return finer;
  }

  const metric_field& field_;
  double longest_;
  const cancellation& stop_;
  std::size_t asked_ = 0;
  // Largest number of triangles that are divided: each takes twelve evaluations of the metric.
  static constexpr std::size_t most_ = 1000000;
  // Complexity of a triangle below which it is not divided to make its own sum more precise.
  static constexpr double smallest_part_ = 1e-9;
  std::optional<error> failure_;
};

// Grades the tensors at the vertices of the field's own mesh.
graded_metric grade_at_nodes(const mesh& background, double beta) {
  const mesh_links links(background);
  std::vector<metric_tensor> tensors;
  for (const site& s : background.sites) tensors.push_back(s.metric);
  const auto done = grade_on_graph(background, links, beta, gradation_space::metric, tensors);
  mesh graded = background;
  gradation_report report;
  report.beta = beta;
  report.nodes = tensors.size();
  report.changed = done.changed;
  report.sweeps = static_cast<int>(done.rounds);
  report.settled = done.ended;
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    const double growth = plain_root_of_determinant(tensors[v]) /
                          plain_root_of_determinant(background.sites[v].metric);
    report.largest_growth = std::max(report.largest_growth, growth);
    graded.sites[v].metric = tensors[v];
  }
  return {make_interpolated_field(graded), report};
}

}  // namespace

result<graded_metric> grade_as_given(std::unique_ptr<metric_field> field, const domain& d,
                                     const gradation_options& options) {
  if (field->background() == nullptr) return grade_metric(std::move(field), d.box(), options);
  if (!(options.beta > 1 && std::isfinite(options.beta)))
    return error{"gradation: a finite number above 1 is wanted"};
  auto graded = grade_at_nodes(*field->background(), options.beta);
  if (graded.report.changed == 0) graded.field = std::move(field);
  return graded;
}

result<double> complexity_over(const domain& d, const metric_field& field,
                               const cancellation& stop) {
  if (const mesh* const background = background_of_domain(d, field))
    return background_metric(*background).complexity();
  mesh_options options;
  options.stop = stop;
  options.max_sites = std::max(options.max_sites, 4 * d.vertices.size());
  const auto coarse = coarse_mesh(d, field, options);
  if (!coarse)
    return error{"the domain could not be triangulated to measure the metric's complexity"};
  const bounding_box box = d.box();
  density_integral integral(field, std::max(box.high.x - box.low.x, box.high.y - box.low.y), stop);
  double sum = 0;
  for (const triangle& t : coarse->triangles) {
    const auto part = integral.over(coarse->sites[t[0]].position, coarse->sites[t[1]].position,
                                    coarse->sites[t[2]].position);
    if (!part) return part.failure();
    sum += part.value();
  }
  return sum;
}

}  // namespace asterism::internal
