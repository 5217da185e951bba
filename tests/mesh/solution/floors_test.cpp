// SPDX-License-Identifier: MIT
//
// Bounds from below on densities, and longest edges: flat parts take a small share of the
// complexity, and are reported.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/optimal_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"
#include "asterism/tests/mesh/solution/made_metric.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::field;
using tests::made;
using tests::sample_mesh;

namespace {

// A grid of [-1,1]^2 with cells that become smaller toward the middle, down to 2e-13 for a power of
// 8.
mesh graded_mesh(double power) {
  constexpr vertex_index half = 40;
  mesh m = sample_mesh(2 * half);
  const auto bent = [power](double x) {
    const double even = std::round(x * half) / half;
    return std::copysign(std::pow(std::abs(even), power), even);
  };
  for (site& s : m.sites) s.position = {bent(s.position.x), bent(s.position.y)};
  return m;
}

// Returns second derivatives of log(r^2 + w^2) / 2.
std::vector<metric_tensor> softened_log(const mesh& m, double w) {
  std::vector<metric_tensor> made;
  for (const site& s : m.sites) {
    const double x = s.position.x, y = s.position.y, q = x * x + y * y + w * w;
    made.push_back({(q - 2 * x * x) / (q * q), -2 * x * y / (q * q), (q - 2 * y * y) / (q * q)});
  }
  return made;
}

// Returns the share of the complexity in places whose density is the bound from below.
double part_of_flat(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas) {
  const auto density = [](const metric_tensor& t) {
    const symmetric_eigen e = eigen_of(t);
    return std::sqrt(e.first) * std::sqrt(e.second);
  };
  double least = std::numeric_limits<double>::infinity(), flat = 0;
  for (const metric_tensor& t : tensors) least = std::min(least, density(t));
  for (std::size_t v = 0; v < tensors.size(); ++v)
    if (density(tensors[v]) <= least * (1 + 1e-6)) flat += areas[v] * least;
  return flat / complexity_of(tensors, areas);
}

// Returns the bounds for a mesh of 4,000 vertices of a square of side 2.
constexpr optimum_bounds usual_bounds{usual_floor_share, 1.0 / 4 / 3464};

double greatest_size(const std::vector<metric_tensor>& tensors) {
  double weak = std::numeric_limits<double>::infinity();
  for (const metric_tensor& t : tensors) weak = std::min(weak, eigen_of(t).second);
  return 1 / std::sqrt(weak);
}

}  // namespace

TEST_CASE("a peak however sharp does not flood what is far from it") {
  const mesh m = graded_mesh(4);
  const auto areas = nodal_areas(m, mesh_links(m));
  std::vector<double> errors;
  for (const double w : {1e-4, 1e-5, 1e-6}) {
    const auto h = softened_log(m, w);
    const auto made = make_optimal_metric(h, areas, 2.0, false, usual_bounds);
    CHECK(complexity_of(made.tensors, areas) == Approx(1).epsilon(1e-9));
    CHECK(part_of_flat(made.tensors, areas) <= usual_floor_share);
    CHECK(made.flat_part <= usual_floor_share);
    errors.push_back(predicted_error(made.tensors, h, areas, 2.0));
  }
  CHECK(errors[1] == Approx(errors[0]).epsilon(0.1));
  CHECK(errors[2] == Approx(errors[0]).epsilon(0.1));
}

TEST_CASE("sizes may differ by a factor of a hundred million") {
  const mesh m = graded_mesh(8);
  const auto areas = nodal_areas(m, mesh_links(m));
  for (const std::optional<double> norm : {std::optional(2.0), std::optional<double>()}) {
    const auto made = make_optimal_metric(softened_log(m, 1e-13), areas, norm, false, usual_bounds);
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (const metric_tensor& t : made.tensors) {
      REQUIRE(std::isfinite(t.m11 + t.m22));
      least = std::min(least, eigen_of(t).first);
      greatest = std::max(greatest, eigen_of(t).first);
    }
    CHECK(std::sqrt(greatest / least) > 1e8);
  }
}

TEST_CASE("along a straight layer edges are as long as allowed, across it sizes follow the layer") {
  // Only one second derivative is not zero: exp(-30 (x + 1)). Across, sizes are proportional to its
  // power -p / (2p+1), as in one dimension. Where the density would be below its bound, edges are
  // shorter.
  const mesh m = sample_mesh(40);
  const auto areas = nodal_areas(m, mesh_links(m));
  const double least =
      usual_floor_share / 4;  // least density on a square of area 4, for a complexity of 1
  for (const double p : {1.0, 2.0, 5.0}) {
    std::vector<metric_tensor> h;
    for (const site& s : m.sites) h.push_back({std::exp(-30 * (s.position.x + 1)), 0, 0});
    const double longest = least / 50;
    const auto made = make_optimal_metric(h, areas, p, false, {usual_floor_share, longest});
    CHECK(made.floored == m.sites.size());
    CHECK(made.flat_part == Approx(part_of_flat(made.tensors, areas)).epsilon(1e-6));
    CHECK(made.flat_part <= usual_floor_share);
    CHECK(made.flat_part + made.ridge_part == Approx(1));
    double product = 0;
    std::size_t between = 0;
    for (std::size_t v = 0; v < h.size(); ++v) {
      const auto [m11, m12, m22] = made.tensors[v];
      CHECK(m12 == 0);
      CHECK(m22 >= longest * (1 - 1e-9));
      CHECK(m11 >= m22 * (1 - 1e-9));
      if (m11 * m22 < 1.001 * least * least) {
        CHECK(m11 * m22 == Approx(least * least));
        between += m22 < 0.99 * least ? 1 : 0;
        continue;
      }
      CHECK(m22 == Approx(longest));
      const double found = m11 / std::pow(h[v].m11, 2 * p / (2 * p + 1));
      if (product == 0) product = found;
      CHECK(found == Approx(product));
    }
    CHECK(product > 0);
    CHECK(between > 0);
    // If no edge may be longer than those of flat places, the error is over ten times as great.
    const auto shorter = make_optimal_metric(h, areas, p, false, {usual_floor_share, least});
    CHECK(predicted_error(made.tensors, h, areas, p) <
          0.1 * predicted_error(shorter.tensors, h, areas, p));
  }
}

TEST_CASE("edges as long as the domain along a straight layer are told, whatever the target") {
  const mesh m = sample_mesh(40);
  nodal_hessian ridge{"u", {}};
  for (const site& s : m.sites) ridge.at.push_back({std::exp(-10 * (s.position.x + 1)), 0, 0});
  for (const bool is_error : {false, true}) {
    solution_metric_options options;
    options.gradation.reset();
    if (is_error)
      options.error = 1e-10;
    else
      options.vertices = 20000;
    const auto metric = make_hessian_metric(m, {ridge}, options);
    REQUIRE(metric.ok());
    const solution_metric_report& told = metric.value().report;
    CHECK(told.reached);
    CHECK(told.complexity_at_least_density <= usual_floor_share);
    CHECK(told.complexity_along_ridges + told.complexity_at_least_density == Approx(1));
    const double longest = greatest_size(metric.value().tensors);
    INFO("with an error wanted: " << is_error << ", the longest edge " << longest);
    CHECK(longest > 2 / 1.25);
    CHECK(longest < 2 * 1.25);
  }
  // A function with curvature everywhere has no place at the bound.
  solution_metric_options options;
  options.vertices = 2000;
  const auto bowl = field(m, "u", [](const point& q) { return q.x * q.x + q.y * q.y; });
  CHECK(made(m, {bowl}, options).report.complexity_along_ridges == 0);
}

TEST_CASE("least sizes do not flood what is far either") {
  // Without the bound, nearly all of the complexity would be in places of great density.
  const mesh m = graded_mesh(3);
  solution_metric_options options;
  options.vertices = 3000;
  options.norm.reset();
  options.least_size = 0.01;
  const auto peak = [](const point& q) {
    return 1 / (1 + (q.x * q.x + q.y * q.y) / (0.001 * 0.001));
  };
  const auto metric = made(m, {field(m, "u", peak)}, options);
  CHECK(metric.report.reached);
  CHECK(metric.report.share_least_size > 0.05);
  CHECK(part_of_flat(metric.tensors, nodal_areas(m, mesh_links(m))) < 2 * usual_floor_share);
}
