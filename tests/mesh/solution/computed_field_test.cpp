// SPDX-License-Identifier: MIT
//
// Distinguishes values that solve equations from values of functions. Layers of computed solutions
// bound aspects.
#include "asterism/mesh/solution/computed_field.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/solution/field_derivatives.hpp"
#include "asterism/mesh/solution/mean_moduli.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"
#include "asterism/tests/mesh/solution/made_metric.hpp"

using namespace asterism;
using namespace asterism::internal;
using tests::field;
using tests::sample_mesh;

namespace {

// A grid of [-1,1]^2 with cells that become narrower toward the sides. By a fixed seed, inner
// vertices are moved by up to a sixth of a cell and half of the diagonals are flipped.
mesh irregular(vertex_index cells) {
  mesh m = sample_mesh(cells);
  std::mt19937 random(41);
  const auto shift = [&] {
    return (static_cast<double>(random()) / 0x1p31 - 1) / (3.0 * static_cast<double>(cells));
  };
  const auto bent = [](double x) { return std::sin(std::numbers::pi / 2 * x); };
  for (site& s : m.sites) {
    point& p = s.position;
    const bool is_inner = std::abs(p.x) < 1 && std::abs(p.y) < 1;
    const point moved{p.x + shift(), p.y + shift()};
    if (is_inner) p = moved;
    p = {bent(p.x), bent(p.y)};
  }
  for (std::size_t t = 0; t < m.triangles.size(); t += 2) {
    const auto [a, b, c] = m.triangles[t];
    const vertex_index d = m.triangles[t + 1][2];
    if (random() % 2 == 0) continue;
    m.triangles[t] = {a, b, d};
    m.triangles[t + 1] = {b, c, d};
  }
  return m;
}

// Assembles linear elements for -w^2 lap u + c u = 1 with u = 0 on the sides, triangle by triangle.
class linear_elements {
 public:
  linear_elements(const mesh& m, double w, double c)
      : mesh_(m), links_(m), diffusion_(w * w), reaction_(c) {}

  // Solves by conjugate gradients.
  std::vector<double> solve() const {
    std::vector<double> u(mesh_.sites.size(), 0.0), r = load(), p = r, product;
    double square = dot(r, r);
    const double least = 1e-24 * square;
    for (int step = 0; step < 3000 && square > least; ++step) {
      product = applied(p);
      const double along = square / dot(p, product);
      for (std::size_t i = 0; i < u.size(); ++i) u[i] += along * p[i], r[i] -= along * product[i];
      const double next = dot(r, r);
      for (std::size_t i = 0; i < u.size(); ++i) p[i] = r[i] + next / square * p[i];
      square = next;
    }
    return u;
  }

 private:
  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  double area(const triangle& t) const {
    const point &a = mesh_.sites[t[0]].position, &b = mesh_.sites[t[1]].position,
                &c = mesh_.sites[t[2]].position;
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  void fix_sides(std::vector<double>& r) const {
    for (vertex_index v = 0; v < r.size(); ++v)
      if (links_.on_boundary(v)) r[v] = 0;
  }
  std::vector<double> load() const {
    std::vector<double> r(mesh_.sites.size(), 0.0);
    for (const triangle& t : mesh_.triangles)
      for (const vertex_index v : t) r[v] += area(t) / 3;
    fix_sides(r);
    return r;
  }
  std::vector<double> applied(const std::vector<double>& p) const {
    std::vector<double> r(p.size(), 0.0);
    for (const triangle& t : mesh_.triangles) {
      const double size = area(t);
      std::array<point, 3> slope;  // gradients of the hat functions
      point whole{0, 0};
      for (std::size_t i = 0; i < 3; ++i) {
        const point &a = mesh_.sites[t[(i + 1) % 3]].position,
                    &b = mesh_.sites[t[(i + 2) % 3]].position;
        slope[i] = {(a.y - b.y) / (2 * size), (b.x - a.x) / (2 * size)};
        whole = {whole.x + p[t[i]] * slope[i].x, whole.y + p[t[i]] * slope[i].y};
      }
      const double sum = p[t[0]] + p[t[1]] + p[t[2]];
      for (std::size_t i = 0; i < 3; ++i)
        r[t[i]] += size * (diffusion_ * (whole.x * slope[i].x + whole.y * slope[i].y) +
                           reaction_ * (sum + p[t[i]]) / 12);
    }
    fix_sides(r);
    return r;
  }

  const mesh& mesh_;
  mesh_links links_;
  double diffusion_, reaction_;
};

layer_measures measured(const mesh& m, const std::vector<double>& values) {
  const auto found = measures_of_layers(m, mesh_links(m), values);
  REQUIRE(found);
  return *found;
}

double greatest_aspect(const std::vector<metric_tensor>& tensors) {
  double greatest = 1;
  for (const metric_tensor& t : tensors) {
    const symmetric_eigen e = eigen_of(t);
    greatest = std::max(greatest, std::sqrt(e.first / e.second));
  }
  return greatest;
}

}  // namespace

TEST_CASE("solutions in linear elements are told from values of functions") {
  const mesh m = irregular(32);
  CHECK(share_of_computed(measured(m, linear_elements(m, 0.1, 1).solve())) == 1);
  CHECK(share_of_computed(measured(m, linear_elements(m, 0.2, 1).solve())) == 1);
  CHECK(share_of_computed(measured(m, linear_elements(m, 1, 0).solve())) == 1);
  const std::vector<std::function<double(const point&)>> functions = {
      [](const point& q) { return std::exp(-(q.x + 1) / 0.1); },
      [](const point& q) { return std::tanh(10 * (q.x - q.y * q.y)); },
      [](const point& q) { return std::sin(6 * q.x) * std::cos(5 * q.y); },
      [](const point& q) { return q.x * q.x + 0.01 * q.y * q.y; },
      [](const point& q) { return std::sqrt(q.x * q.x + q.y * q.y + 1e-4); }};
  for (const mesh& on : {m, sample_mesh(20), sample_mesh(40)})
    for (std::size_t i = 0; i < functions.size(); ++i) {
      INFO("function " << i << ", " << on.sites.size() << " vertices");
      CHECK(share_of_computed(measured(on, field(on, "u", functions[i]).values)) == 0);
      CHECK(!aspect_bound(on, mesh_links(on), field(on, "u", functions[i]).values));
    }
}

TEST_CASE("steepness counts layers over the diagonal, whatever the mesh and the units") {
  for (const double w : {0.4, 0.2, 0.1})
    for (const vertex_index cells : {vertex_index{32}, vertex_index{48}}) {
      const mesh m = irregular(cells);
      auto values = field(m, "u", [w](const point& q) { return std::exp(-(q.x + 1) / w); }).values;
      // The mean slope of exp(-t/w), weighted by its square: two thirds of 1/w where 2/w is large.
      const double end = std::exp(-2 / w), range = 1 - end,
                   mean = (1 - end * end * end) / 3 / ((1 - end * end) / 2) / w;
      CHECK(steepness(m, values) == Approx(2 * std::numbers::sqrt2 * mean / range).epsilon(0.02));
      const double before = steepness(m, values);
      for (double& u : values) u = 0x1p300 * u;
      CHECK(steepness(m, values) == before);
    }
  const mesh m = irregular(8);
  CHECK(steepness(m, std::vector<double>(m.sites.size(), 3)) == 0);
}

TEST_CASE("the aspect wanted along layers is that of the second derivatives, in any units") {
  const mesh m = irregular(48);
  const auto aspect_of = [](const mesh& on, const std::vector<double>& values) {
    return measured(on, values).aspect;
  };
  // Outside of a circle of radius r, at distance t, exp(-t/w) has second derivatives of its slope
  // over w across the layer, and of its slope over t + r along it.
  constexpr double w = 0.1, r = 1.5;
  const auto round = [](const point& q) {
    return std::exp(-(std::hypot(q.x + 1 + r, q.y) - r) / w);
  };
  auto values = field(m, "u", round).values;
  const double aspect = aspect_of(m, values);
  CHECK(aspect == Approx(std::sqrt(r / w)).epsilon(0.15));
  for (double& u : values) u *= 0x1p200;
  CHECK(aspect_of(m, values) == aspect);
  mesh small = m;
  for (site& s : small.sites) s.position = {0x1p-200 * s.position.x, 0x1p-200 * s.position.y};
  CHECK(aspect_of(small, field(m, "u", round).values) == aspect);
  // A straight layer that is the same everywhere along itself wants any aspect.
  const auto straight = [](const point& q) { return std::exp(-(q.x - 0.3 * q.y) / (4 * w)); };
  CHECK(aspect_of(m, field(m, "u", straight).values) > 15);
}

TEST_CASE("a mesh that is too small to tell bounds nothing") {
  const mesh m = sample_mesh(4);
  CHECK(!measures_of_layers(m, mesh_links(m),
                            field(m, "u", [](const point& q) { return q.x * q.x; }).values));
  const mesh flat = sample_mesh(12);
  CHECK(!aspect_bound(flat, mesh_links(flat), std::vector<double>(flat.sites.size(), 1)));
}

TEST_CASE("weaker eigenvalues are raised to the stronger over the square of the aspect") {
  std::vector<metric_tensor> tensors = {{100, 0, 1}, {1, 0, 400}, {2, 0, 1}, {50.5, 49.5, 50.5}};
  const auto before = tensors;
  bound_aspects(5, tensors);
  CHECK(tensors[0].m22 == 4);
  CHECK(tensors[1].m11 == 16);
  CHECK(identical(tensors[2], before[2]));
  const symmetric_eigen turned = eigen_of(tensors[3]);
  CHECK(turned.first == Approx(100));
  CHECK(turned.second == Approx(4));
  tensors = before;
  bound_aspects(25, tensors);
  for (std::size_t i = 0; i < tensors.size(); ++i) CHECK(identical(tensors[i], before[i]));
}

TEST_CASE("layers of a solution bound aspects where none is named, and the steps say so") {
  const mesh m = irregular(32);
  const std::vector<nodal_values> computed = {{"u", linear_elements(m, 0.1, 1).solve()}};
  solution_metric_options options;
  const auto bound = make_solution_metric(m, computed, options);
  REQUIRE(bound.ok());
  CHECK(bound.value().report.steps == std::vector<std::string>{"hessian green", "moduli",
                                                               "optimum 2", "layers 10.09",
                                                               "factor", "aspect 1e+06"});
  const mesh_links links(m);
  const auto asked = aspect_bound(m, links, computed[0].values);
  REQUIRE(asked);
  CHECK(greatest_aspect(bound.value().tensors) <= *asked * (1 + 1e-9));
  // Recomputes the bound, here 1.5 times the aspect wanted, which lies between the other two.
  const layer_measures layers = measured(m, computed[0].values);
  CHECK(*asked == bound_of_wanted_aspect * layers.aspect);
  CHECK(*asked > least_aspect_bound);
  CHECK(*asked < steepness(m, computed[0].values));
  // Layers of twice the thickness want less than the least bound.
  CHECK(aspect_bound(m, links, linear_elements(m, 0.2, 1).solve()) == least_aspect_bound);
  options.aspect = 1e5;
  const auto named = make_solution_metric(m, computed, options);
  REQUIRE(named.ok());
  CHECK(std::count(named.value().report.steps.begin(), named.value().report.steps.end(),
                   "layers 10.09") == 0);
  CHECK(greatest_aspect(named.value().tensors) > 15);
}

TEST_CASE("peaks of second derivatives count where a function has them, not where they are noise") {
  const mesh m = irregular(32);
  const mesh_links links(m);
  const auto is_made_by = [&](const nodal_values& values, const solution_metric_options& options,
                              const auto& mean) {
    const auto found = recovered_derivatives(m, links, {values}, options, nullptr);
    REQUIRE(found.ok());
    const auto& [recovered, moduli] =
        std::pair(found.value().recovered[0], found.value().moduli[0]);
    const auto expected = mean(recovered);
    bool is_same = true;
    for (std::size_t v = 0; v < moduli.size(); ++v)
      is_same = is_same && identical(moduli[v], expected[v]);
    return is_same;
  };
  const auto plain = [&](const auto& h) { return mean_moduli(m, links, h); };
  const auto peaks = [&](const auto& h) { return mean_moduli_with_peaks(m, links, h, 0.4); };
  const nodal_values computed{"u", linear_elements(m, 0.1, 1).solve()},
      function = field(m, "u", [](const point&q) { return std::tanh(10 * (q.x - q.y * q.y)); });
  solution_metric_options options;
  for (const double aspect : {no_aspect_named, 100.0}) {
    options.aspect = aspect;
    CHECK(is_made_by(computed, options, plain));
    CHECK(!is_made_by(computed, options, peaks));
    CHECK(is_made_by(function, options, peaks));
  }
  options.relative = true;
  CHECK(is_made_by(function, options, plain));
}
