// SPDX-License-Identifier: MIT
//
// Recovers second derivatives. Linear and quadratic fields give them to rounding where the method
// promises it; rounding of the values gives none; the result does not depend on the number of
// threads.
#include "asterism/mesh/solution/hessian.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "asterism/core/random.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using tests::sample_mesh;

namespace {

std::vector<double> values_of(const mesh& m, const std::function<double(const point&)>& f) {
  std::vector<double> values;
  for (const site& s : m.sites) values.push_back(f(s.position));
  return values;
}

double greatest_error(const recovered_hessian& found, const metric_tensor& exact) {
  double greatest = 0;
  for (const metric_tensor& h : found.at)
    greatest = std::max({greatest, std::abs(h.m11 - exact.m11), std::abs(h.m12 - exact.m12),
                         std::abs(h.m22 - exact.m22)});
  return greatest;
}

recovered_hessian recovered(const mesh& m, const std::vector<double>& values,
                            hessian_method method) {
  auto found = recover_hessian(m, values, method);
  REQUIRE(found.ok());
  return std::move(found).value();
}

// Returns the cells of a grid, with diagonals in one direction, `flatness` times as wide as high.
mesh grid(vertex_index n, double flatness) {
  mesh m;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i)
      m.sites.push_back({{1.0 * i / n, j / (n * flatness)}, {1, 0, 1}});
  for (vertex_index j = 0; j < n; ++j)
    for (vertex_index i = 0; i < n; ++i) {
      const vertex_index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

const metric_tensor quadratic{6, -1, 4};
double quadratic_at(const point& q) {
  return 1 + q.x - 2 * q.y + 3 * q.x * q.x - q.x * q.y + 2 * q.y * q.y;
}

}  // namespace

TEST_CASE("a linear field has no second derivatives, whatever the method and the mesh") {
  const mesh m = sample_mesh(12);
  const auto values = values_of(m, [](const point& q) { return 1e3 + 2 * q.x - 7 * q.y; });
  for (const auto method :
       {hessian_method::l2_projection, hessian_method::green, hessian_method::least_squares}) {
    const auto found = recovered(m, values, method);
    CHECK(greatest_error(found, {0, 0, 0}) == 0);
    CHECK(found.noise == m.sites.size());
  }
}

TEST_CASE("least squares recover a quadratic field to rounding on any mesh, at the boundary too") {
  for (const mesh& m : {sample_mesh(9), grid(8, 1), grid(8, 1e4)}) {
    const auto found = recovered(m, values_of(m, quadratic_at), hessian_method::least_squares);
    // Values of size 5 at distances of 1/8: rounding is multiplied by 64, and by the square of the
    // flatness.
    const double height = m.sites.back().position.y;
    CHECK(greatest_error(found, quadratic) <= 1e-11 * std::max(1.0, 1 / (height * height)));
    CHECK(found.at_boundary == 0);
  }
}

TEST_CASE("averages and the weak form recover a quadratic field on a grid") {
  const mesh m = grid(10, 3);
  const auto values = values_of(m, quadratic_at);
  for (const auto method : {hessian_method::l2_projection, hessian_method::green}) {
    const auto found = recovered(m, values, method);
    CHECK(greatest_error(found, quadratic) < 1e-10);
    // At the boundary the weak form is replaced by quadratics.
    CHECK(found.at_boundary == (method == hessian_method::green ? 0 : 40));
  }
}

TEST_CASE("averages come near the derivatives of a smooth field on an irregular mesh") {
  const mesh m = sample_mesh(40);
  const auto values =
      values_of(m, [](const point& q) { return std::sin(3 * q.x) * std::exp(q.y); });
  for (const auto method :
       {hessian_method::l2_projection, hessian_method::green, hessian_method::least_squares}) {
    const auto found = recovered(m, values, method);
    double sum = 0;
    for (std::size_t v = 0; v < m.sites.size(); ++v)
      sum += std::abs(found.at[v].m11 + 9 * values[v]) + std::abs(found.at[v].m22 - values[v]);
    CHECK(sum / static_cast<double>(m.sites.size()) <
          (method == hessian_method::green ? 2.0 : 0.6));
  }
}

TEST_CASE("waves of three edges are seen by all but averages of averages") {
  constexpr vertex_index n = 30;
  const double k = 2 * std::acos(-1.0) * n / 3;  // a wavelength is three edges of the grid
  const mesh m = grid(n, 1);
  const auto values = values_of(m, [&](const point& q) { return std::sin(k * q.x + 0.4); });
  const auto seen = [&](hessian_method method) {
    const auto found = recovered(m, values, method);
    double greatest = 0;  // over vertices away from the boundary
    for (std::size_t v = 0; v < m.sites.size(); ++v) {
      const point& q = m.sites[v].position;
      if (std::abs(q.x - 0.5) < 0.2 && std::abs(q.y - 0.5) < 0.2)
        greatest = std::max(greatest, std::abs(found.at[v].m11));
    }
    return greatest / (k * k);
  };
  // Second differences of a wave with kh = 2 pi / 3 keep the part (sin(kh/2) / (kh/2))^2 = 0.68,
  // and averages of averages at most (sin(kh) / kh)^2 = 0.17.
  CHECK(seen(hessian_method::green) > 0.6);
  CHECK(seen(hessian_method::least_squares) > 0.3);
  CHECK(seen(hessian_method::l2_projection) < 0.2);
}

TEST_CASE("a mesh without inner vertices has what its boundary has") {
  mesh m;
  m.sites = {{{0, 0}, {}}, {{1, 0}, {}}, {{1, 1}, {}}, {{0, 1}, {}}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const auto method :
       {hessian_method::l2_projection, hessian_method::green, hessian_method::least_squares})
    CHECK(recover_hessian(m, {0, 1, 4, 2}, method).ok());
}

TEST_CASE("derivatives that overflow are refused with the vertex") {
  mesh m = grid(4, 1);
  for (site& s : m.sites) s.position = {s.position.x * 1e-80, s.position.y * 1e-80};
  std::vector<double> values(m.sites.size(), 0);
  values[12] = 1;
  const auto found = recover_hessian(m, values);
  REQUIRE_FALSE(found.ok());
  CHECK(found.failure().message.find("vertex") != std::string::npos);
  CHECK_FALSE(recover_hessian(m, {1, 2}).ok());
}

TEST_CASE("derivatives whose squares underflow are refused, and none at all are not") {
  mesh m = grid(4, 1);
  for (site& s : m.sites) s.position = {s.position.x * 1e80, s.position.y * 1e80};
  std::vector<double> values(m.sites.size(), 0);
  CHECK(recover_hessian(m, values).ok());
  values[12] = 1;
  const auto found = recover_hessian(m, values);
  REQUIRE_FALSE(found.ok());
  CHECK(found.failure().message.find("another unit") != std::string::npos);
}

TEST_CASE("the Hessian is the same for any number of threads") {
  const mesh m = sample_mesh(90);
  const auto values = values_of(m, [](const point& q) { return std::tanh(9 * (q.x - q.y * q.y)); });
  for (const auto method :
       {hessian_method::l2_projection, hessian_method::green, hessian_method::least_squares}) {
    const auto many = recovered(m, values, method);
    const internal::thread_limit one(1);
    CHECK(many.at == recovered(m, values, method).at);
  }
}
