// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/graded_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "asterism/mesh/gradation/gradation_grid.hpp"
#include "asterism/mesh/gradation/gradation_sweep.hpp"
#include "asterism/mesh/metric/graded_parts.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism {
using namespace internal;

namespace {

// Evaluates to the field as given between nodes that are kept, and to the mean of logarithms
// between others. In triangles with both kinds of nodes the given field's logarithm at the point
// takes the place of the kept nodes' logarithms, so that the result is continuous.
class graded_field : public metric_field, public graded_parts {
 public:
  graded_field(std::unique_ptr<metric_field> given, gradation_grid grid,
               std::vector<tensor_logarithm> logs, std::vector<bool> kept)
      : given_(std::move(given)),
        grid_(std::move(grid)),
        logs_(std::move(logs)),
        kept_(std::move(kept)) {}

  result<metric_tensor> at(const point& q) const override {
    const gradation_grid::place place = grid_.locate(q);
    double weight_of_given = 0, weight_of_nodes = 0;
    tensor_logarithm sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double w = place.weight[i];
      if (w == 0) continue;
      (kept_[place.node[i]] ? weight_of_given : weight_of_nodes) += w;
      if (!kept_[place.node[i]]) add(sum, w, logs_[place.node[i]]);
    }
    if (weight_of_nodes == 0) return given_->at(q);
    if (weight_of_given > 0) {
      const auto given = given_->at(q);
      if (!given.ok()) return given.failure();
      add(sum, weight_of_given, logarithm(given.value()));
    }
    return checked_tensor(q, exponential(sum));
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    given_->expect(places);
  }
  std::vector<graded_triangle> triangles() const override {
    std::vector<graded_triangle> all;
    for (const gradation_grid::cell& c : grid_.cells()) {
      if (!c.leaf()) continue;
      const gradation_grid::rim rim = grid_.rim_of(c);
      for (std::size_t i = 0; i < rim.size; ++i) {
        graded_triangle& t = all.emplace_back();
        const std::array<std::uint32_t, 3> nodes{c.middle, rim.node[i],
                                                 rim.node[(i + 1) % rim.size]};
        for (std::size_t k = 0; k < 3; ++k) {
          t.corners[k] = grid_.position(nodes[k]);
          t.logarithms[k] = logs_[nodes[k]];
          t.kept[k] = kept_[nodes[k]];
        }
      }
    }
    return all;
  }
  const metric_field& given() const override { return *given_; }

 private:
  static void add(tensor_logarithm& sum, double w, const tensor_logarithm& l) {
    sum.l11 += w * l.l11;
    sum.l12 += w * l.l12;
    sum.l22 += w * l.l22;
  }

  std::unique_ptr<metric_field> given_;
  gradation_grid grid_;
  std::vector<tensor_logarithm> logs_;
  std::vector<bool> kept_;
};

std::optional<error> check(const gradation_options& options, const bounding_box& box) {
  if (!(options.beta > 1) || !std::isfinite(options.beta))
    return error{fmt::format("gradation: beta must be above 1 and finite, not {}", options.beta),
                 error_code::bad_option};
  if (options.max_nodes < 1 || options.max_sweeps < 1)
    return error{"gradation: at least one node and one sweep must be allowed",
                 error_code::bad_option};
  if (!frame_in_the_middle(box))
    return error{"gradation: the domain has no extent, or more than a double can hold",
                 error_code::bad_option};
  return std::nullopt;
}

// Sets the range of the longer sides of the leaves.
void measure_cells(const gradation_grid& grid, gradation_report& report) {
  bool first = true;
  for (const gradation_grid::cell& c : grid.cells()) {
    if (!c.leaf()) continue;
    const point d = grid.diagonal(c);
    const double side = std::max(d.x, d.y);
    report.smallest_cell = first ? side : std::min(report.smallest_cell, side);
    report.largest_cell = std::max(report.largest_cell, side);
    first = false;
  }
}

gradation_report summary(const gradation_sweep& sweep, const gradation_grid& grid) {
  gradation_report report = sweep.report();
  report.nodes = sweep.nodes().size();
  for (const gradation_sweep::node& n : sweep.nodes()) {
    if (!n.altered) continue;
    ++report.changed;
    report.largest_growth = std::max(report.largest_growth, density_ratio(n.now, n.given));
  }
  measure_cells(grid, report);
  return report;
}

}  // namespace

result<graded_metric> grade_metric(std::unique_ptr<metric_field> field, const bounding_box& box,
                                   const gradation_options& options) {
  if (auto failure = check(options, box)) return *failure;
  gradation_grid grid(box);
  gradation_sweep sweep(*field, grid, options);
  if (auto failure = sweep.run()) return *failure;
  const gradation_report report = summary(sweep, grid);
  if (report.changed == 0) return graded_metric{std::move(field), report};
  std::vector<tensor_logarithm> logs;
  logs.reserve(sweep.nodes().size());
  for (const gradation_sweep::node& n : sweep.nodes()) logs.push_back(n.now_log);
  std::vector<bool> kept = sweep.kept();
  return graded_metric{std::make_unique<graded_field>(std::move(field), std::move(grid),
                                                      std::move(logs), std::move(kept)),
                       report};
}

}  // namespace asterism
