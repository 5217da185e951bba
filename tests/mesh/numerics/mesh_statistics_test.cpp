// SPDX-License-Identifier: MIT
//
// Statistics of meshes whose numbers are known.
#include "asterism/mesh/numerics/mesh_statistics.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using asterism::test::make_mesh_of;
using asterism::test::splitmix64;

namespace {

// Returns the eigenvalues of M_p^-1 M_q, least first: with M_p = L L^T those of the symmetric
// L^-1 M_q L^-T.
std::pair<double, double> eigenvalues(const metric_tensor& p, const metric_tensor& q) {
  const long double l11 = std::sqrt(static_cast<long double>(p.m11)), l21 = p.m12 / l11;
  const long double l22 = std::sqrt(p.m22 - l21 * l21);
  const long double a = q.m11 / (l11 * l11);
  const long double b = (q.m12 / l11 - l21 * a) / l22;
  const long double c = (q.m22 - 2 * l21 * q.m12 / l11 + l21 * l21 * a) / (l22 * l22);
  const long double middle = (a + c) / 2, half = std::hypot((a - c) / 2, b);
  return {static_cast<double>(middle - half), static_cast<double>(middle + half)};
}

}  // namespace

TEST_CASE("a unit equilateral triangle is perfect in every number") {
  const mesh_statistics s =
      measure(make_mesh_of({{0, 0}, {1, 0}, {0.5, std::sqrt(3) / 2}}, {{0, 1, 2}}));
  CHECK(s.edges == 3);
  CHECK(s.unit_edges == 1);
  CHECK(s.mean_length == Approx(1));
  CHECK(s.mean_quality == Approx(1));
  CHECK(s.least_quality == Approx(1));
  CHECK(s.below_20 == 0);
  CHECK(s.below_30 == 0);
  CHECK(s.metric_area == Approx(std::sqrt(3) / 4));
  CHECK(s.count_ratio == Approx(1));
  CHECK(s.sigma == 0);
  CHECK(s.eps == Approx(1 / std::sqrt(3)));
}

TEST_CASE("a square of side 2 cut in two: lengths, quality, area") {
  const mesh_statistics s =
      measure(make_mesh_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}}));
  CHECK(s.edges == 5);
  CHECK(s.unit_edges == 0);
  CHECK(s.mean_length == Approx((8 + 2 * std::sqrt(2)) / 5));
  CHECK(s.mean_quality == Approx(std::sqrt(3) / 2));  // 4 sqrt 3 * 2 / (4 + 4 + 8)
  CHECK(s.metric_area == Approx(4));
  CHECK(s.eps == Approx(std::sqrt(2)));
}

TEST_CASE("a mesh and its image under a linear map, in the metric that undoes it, are alike") {
  const test::patch p = test::make_patch(6);
  const mesh_statistics a = measure(p.m), b = measure(test::stretched(p, 0x1p10).m);
  CHECK(a.edges == b.edges);
  CHECK(a.mean_length == Approx(b.mean_length));
  CHECK(a.mean_quality == Approx(b.mean_quality));
  CHECK(a.least_quality == Approx(b.least_quality));
  CHECK(a.metric_area == Approx(b.metric_area));
  CHECK(a.eps == Approx(b.eps));
}

TEST_CASE("no triangles, no numbers") {
  const mesh_statistics s = measure({});
  CHECK(s.edges == 0);
  CHECK(s.metric_area == 0);
  CHECK(s.count_ratio == 0);
}

TEST_CASE("distortion is the root of the extreme generalized eigenvalue") {
  splitmix64 random(3);
  const auto tensor = [&](double condition) {
    const double t = random.real(0, 3.2), c = std::cos(t), s = std::sin(t);
    const double large = std::exp(random.real(0, std::log(condition)));
    const double scale = std::exp(random.real(-5, 5));
    return metric_tensor{scale * (large * c * c + s * s), scale * (large - 1) * c * s,
                         scale * (large * s * s + c * c)};
  };
  for (int i = 0; i < 2000; ++i) {
    const metric_tensor p = tensor(1e4), q = tensor(1e4);
    const auto [low, high] = eigenvalues(p, q);
    INFO("replay: pair " << i);
    CHECK(distortion(p, q) == Approx(std::sqrt(std::max({1.0, high, 1 / low}))).epsilon(1e-4));
    CHECK(distortion(p, q) == Approx(distortion(q, p)).epsilon(1e-4));
    CHECK(distortion(p, p) == Approx(1).epsilon(1e-6));
  }
  CHECK(distortion({1, 0, 1}, {1, 0, 1}) == 1);
  CHECK(distortion({1, 0, 1}, {4, 0, 0.25}) == 2);
  CHECK(std::isinf(distortion({1, 0, 1}, {NAN, 0, 1})));
}

TEST_CASE("equal tensors were infinitely different when their entries are 1e400 apart") {
  const metric_tensor thin{1e200, 0, 1e-200}, aslant{1e300, 1e2, 1e-190};
  CHECK(distortion(thin, thin) == 1);
  CHECK(distortion(aslant, aslant) == 1);
  CHECK(variation({{0, 0}, thin}, {{1, 1}, thin}) == 0);
  CHECK(variation({{-1e300, 0}, thin}, {{1e300, 1}, thin}) == 0);
  const metric_tensor none{NAN, 0, 1};
  CHECK(std::isinf(distortion(none, none)));
}

TEST_CASE("distortion of tensors whose determinants leave the range of doubles") {
  // The formula with determinants returns 1 for all tensors of such size, so that no jump of the
  // metric is found.
  for (const double scale : {0x1p800, 0x1p-800, 0x1p-1000, 0x1p1000})
    CHECK(distortion({scale, 0, scale}, {4 * scale, 0, scale / 4}) == 2);
}

TEST_CASE("aspect is the root of the condition number, whatever the size of the entries") {
  for (const double scale : {1.0, 0x1p900, 0x1p-900}) {
    CHECK(aspect({scale, 0, scale}) == 1);
    CHECK(aspect({scale, 0, 1e12 * scale}) == Approx(1e6));
    CHECK(aspect({2.5 * scale, 1.5 * scale, 2.5 * scale}) == Approx(2));
  }
}

TEST_CASE("variation is per unit of the smaller length") {
  // Lengths are twice as long at q: tau = 2, and the edge has lengths 3 and 6.
  CHECK(variation({{0, 0}, {1, 0, 1}}, {{3, 0}, {4, 0, 4}}) == Approx(0.5 / 3));
  CHECK(variation({{0, 0}, {1, 0, 1}}, {{3, 0}, {1, 0, 1}}) == 0);
}
