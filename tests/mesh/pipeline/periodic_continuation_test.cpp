// SPDX-License-Identifier: MIT
//
// Recovers second derivatives across periodic sides as in the interior.
#include "asterism/mesh/pipeline/periodic_continuation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

constexpr vertex_index n = 16;
const std::vector<periodic_pair> torus = {{4, 2}, {1, 3}};

// Returns n x n cells of the unit square with markers 1 to 4 from below to the left. Vertex (i, j)
// has the number (n + 1) j + i.
mesh grid() {
  mesh m;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i)
      m.sites.push_back({{static_cast<double>(i) / n, static_cast<double>(j) / n}, {1, 0, 1}});
  const auto at = [](vertex_index i, vertex_index j) { return (n + 1) * j + i; };
  tests::add_cells(n, at, m);
  return m;
}

// A periodic field with steep fronts, shifted along both axes.
nodal_values front(const mesh& m, double shift) {
  nodal_values u{"u", {}};
  for (const site& s : m.sites) {
    const double x = s.position.x - shift, y = s.position.y - shift;
    const double turn = 6.283185307179586;
    u.values.push_back(std::tanh(2 * std::sin(turn * (x + y)) + std::cos(turn * x)));
  }
  return u;
}

std::vector<metric_tensor> metric_of(const mesh& m, const nodal_values& u, hessian_method how) {
  const auto glued = continued_across(m, torus);
  REQUIRE(glued);
  solution_metric_options wishes;
  wishes.vertices = 500;
  wishes.hessian = how;
  auto made = make_glued_metric(m, *glued, {u}, wishes);
  REQUIRE(made.ok());
  return std::move(made).value().tensors;
}

double apart(const metric_tensor& a, const metric_tensor& b) {
  return (std::abs(a.m11 - b.m11) + std::abs(a.m12 - b.m12) + std::abs(a.m22 - b.m22)) /
         (a.m11 + a.m22);
}

}  // namespace

TEST_CASE("the metric of a periodic solution does not know where the seam is") {
  const mesh m = grid();
  for (const hessian_method how :
       {hessian_method::green, hessian_method::least_squares, hessian_method::l2_projection}) {
    const auto whole = metric_of(m, front(m, 0), how), moved = metric_of(m, front(m, 0.5), how);
    const auto alone = [&] {
      solution_metric_options wishes;
      wishes.vertices = 500;
      wishes.hessian = how;
      return make_solution_metric(m, {front(m, 0)}, wishes).value().tensors;
    }();
    double most = 0, most_alone = 0;
    for (vertex_index j = 0; j <= n; ++j)
      for (vertex_index i = 0; i <= n; ++i) {
        const vertex_index v = (n + 1) * j + i;
        const vertex_index w = (n + 1) * ((j + n / 2) % n) + (i + n / 2) % n;
        most = std::max(most, apart(whole[v], moved[w]));
        most_alone = std::max(most_alone, apart(alone[v], moved[w]));
      }
    CHECK(most < 1e-9);
    CHECK(most_alone > 0.1);
  }
}

TEST_CASE("partners have one tensor, the four corners of a torus too") {
  const mesh m = grid();
  const auto t = metric_of(m, front(m, 0.1), hessian_method::green);
  for (vertex_index k = 0; k <= n; ++k) {
    CHECK(identical(t[(n + 1) * k], t[(n + 1) * k + n]));
    CHECK(identical(t[k], t[(n + 1) * n + k]));
  }
}

// Returns the greatest log distortion between the tensors of partners in the next mesh, over both
// pairs of sides.
double partners_apart(mesh m, const std::vector<metric_tensor>& tensors) {
  for (std::size_t v = 0; v < m.sites.size(); ++v) m.sites[v].metric = tensors[v];
  mesh_adaptation_options options;
  options.refinement.vertices = 500;
  options.periodic = torus;
  const auto next = adapt_to_metric({std::move(m), {}}, options);
  REQUIRE(next.ok());
  REQUIRE(next.value().made.certified());
  REQUIRE(next.value().made.claim.periodic.size() == torus.size());
  double most = 0;
  for (const periodic_match& match : next.value().made.claim.periodic)
    most = std::max(most, match.metrics_apart);
  return most;
}

TEST_CASE("in the next mesh partners are nearer to each other than where sides are boundary") {
  const mesh m = grid();
  const nodal_values u = front(m, 0.1);
  const double glued = partners_apart(m, metric_of(m, u, hessian_method::green));
  solution_metric_options wishes;
  wishes.vertices = 500;
  const double alone = partners_apart(m, make_solution_metric(m, {u}, wishes).value().tensors);
  CAPTURE(glued, alone);
  CHECK(glued < alone / 4);
  wishes.gradation = loop_gradation;
  const double graded = partners_apart(
      m, make_glued_metric(m, *continued_across(m, torus), {u}, wishes).value().tensors);
  CAPTURE(graded);
  CHECK(graded < alone / 2);
}

TEST_CASE("a mesh stays only if its sides match exactly wherever its corners allow that") {
  mesh m = grid();
  for (site& s : m.sites) s.metric = {n * n, 0, n * n};
  mesh_adaptation_options options;
  options.periodic = torus;
  const auto first = adapt_to_metric({std::move(m), {}}, options);
  REQUIRE(first.ok());
  options.keep = keep_rule::always;
  for (const bool is_off : {false, true}) {
    mesh given = first.value().made.outcome.result;
    for (site& s : given.sites) {
      double& y = s.position.y;
      if (is_off && s.position.x == 1 && y > 0 && y < 1) y = std::nextafter(y, 1);
    }
    const auto next = adapt_to_metric({std::move(given), {}}, options);
    REQUIRE(next.ok());
    CHECK(next.value().made.certified());
    CHECK(next.value().kept != is_off);
    for (const periodic_match& one : next.value().made.claim.periodic)
      CHECK(one.kind == periodic_kind::translated);
  }
}

TEST_CASE(
    "sides that do not agree within the work of a run are no complete mesh, and why is said") {
  constexpr double least = 4000, most = 1e6, step = 1.25;
  const mesh m = grid();
  // A front along the diagonals wants edges across the whole torus, and splits its sides.
  nodal_values u{"u", {}};
  for (const site& s : m.sites)
    u.values.push_back(std::tanh(8 * std::sin(6.283185307179586 * (s.position.x - s.position.y))));
  const auto tensors = metric_of(m, u, hessian_method::green);
  std::size_t differing = 0, certified = 0;
  for (double units = least; units < most && certified == 0; units *= step) {
    mesh background = m;
    for (std::size_t v = 0; v < background.sites.size(); ++v)
      background.sites[v].metric = tensors[v];
    mesh_adaptation_options options;
    options.refinement.vertices = 500;
    options.refinement.stop = cancellation().with_work(units);
    options.periodic = torus;
    const auto next = adapt_to_metric({std::move(background), {}}, options);
    REQUIRE(next.ok());
    const certified_mesh& made = next.value().made;
    certified += made.certified() ? 1 : 0;
    if (made.claim.reason.find("splits one side where its partner has no vertex") ==
        std::string::npos)
      continue;
    ++differing;
    CHECK_FALSE(made.certified());
    CHECK(made.claim.periodic.size() < torus.size());
    CHECK(made.claim.reason.find("more vertices, or a stricter gradation") != std::string::npos);
  }
  CHECK(differing > 0);
  CHECK(certified > 0);
}

TEST_CASE(
    "a mesh that is continued is a triangulation, and its copies lie where they are shifted") {
  const mesh m = grid();
  const auto made = continued_across(m, torus);
  REQUIRE(made);
  const mesh& all = made->continued;
  REQUIRE(made->origin.size() == all.sites.size());
  const mesh_links links(all);
  for (vertex_index v = 0; v < m.sites.size(); ++v) CHECK_FALSE(links.on_boundary(v));
  for (std::size_t v = 0; v < all.sites.size(); ++v) {
    const point &p = all.sites[v].position, &q = m.sites[made->origin[v]].position;
    CHECK((p.x - q.x == std::round(p.x - q.x) && p.y - q.y == std::round(p.y - q.y)));
  }
  for (const triangle& t : all.triangles) {
    const point &a = all.sites[t[0]].position, &b = all.sites[t[1]].position,
                &c = all.sites[t[2]].position;
    CHECK((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) == 1.0 / (n * n));
  }
}

TEST_CASE("across turned sides second derivatives are turned, and know nothing of the seam") {
  const double quarter = 1.5707963267948966;
  mesh m;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i) {
      const double r = 1 + static_cast<double>(i) / n, angle = quarter * j / n;
      m.sites.push_back({{r * std::cos(angle), r * std::sin(angle)}, {1, 0, 1}});
    }
  // The sides on the axes are images of each other, exactly.
  for (vertex_index i = 0; i <= n; ++i) m.sites[(n + 1) * n + i].position = {0, 1 + 1.0 * i / n};
  tests::add_cells(
      n, [](vertex_index i, vertex_index j) { return (n + 1) * j + i; }, m);
  const auto tensors_of = [&](double phase) {
    nodal_values u{"u", {}};
    for (const site& s : m.sites) {
      const double r = std::hypot(s.position.x, s.position.y),
                   angle = std::atan2(s.position.y, s.position.x);
      u.values.push_back(std::tanh(4 * (r - 1.5 - 0.1 * std::sin(4 * angle + phase))));
    }
    const auto glued = continued_across(m, {{1, 3}});
    REQUIRE(glued);
    solution_metric_options wishes;
    wishes.vertices = 500;
    return make_glued_metric(m, *glued, {u}, wishes).value().tensors;
  };
  const auto at_seam = tensors_of(0), inside = tensors_of(2 * quarter);
  const double half = std::sqrt(0.5);
  for (vertex_index i = 0; i <= n; ++i) {
    const metric_tensor& t = at_seam[i];
    CHECK(identical(at_seam[(n + 1) * n + i], {t.m22, -t.m12, t.m11}));
    CHECK(apart(turned(t, half, half), inside[(n + 1) * (n / 2) + i]) < 1e-6);
  }
}

TEST_CASE("sides that do not match, or are turned and meet, stay boundary") {
  mesh m = grid();
  CHECK_FALSE(continued_across(m, {}));
  CHECK_FALSE(continued_across(m, {{1, 2}}));
  CHECK_FALSE(continued_across(m, {{1, 9}}));
  m.sites[3].position.x += 0.01;
  CHECK_FALSE(continued_across(m, {{1, 3}}));
  CHECK(continued_across(m, {{1, 3}, {4, 2}}));
}
