// SPDX-License-Identifier: MIT
//
// Clips pairs of tensors to a distortion: never below it, half from each side, and no other tensor
// changes.
#include "asterism/mesh/gradation/nodal_gradation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "asterism/mesh/numerics/metric_algebra.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

// Draws a fixed sequence of tensors: aspects up to 1000, in all directions.
class tensor_sequence {
 public:
  explicit tensor_sequence(std::uint64_t seed) : state_(seed) {}
  metric_tensor next() {
    const double aspect = std::exp(6.9 * uniform()), angle = 3.2 * uniform();
    const double size = std::exp(4 * uniform() - 2);
    const double c = std::cos(angle), s = std::sin(angle);
    const double high = size * aspect, low = size / aspect;
    return {high * c * c + low * s * s, (high - low) * c * s, high * s * s + low * c * c};
  }
  double uniform() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

double determinant(const metric_tensor& m) { return m.m11 * m.m22 - m.m12 * m.m12; }

}  // namespace

TEST_CASE("a pair is clipped to the distortion asked for, with the product of its densities kept") {
  tensor_sequence tensors(1);
  for (int i = 0; i < 500; ++i) {
    INFO("pair " << i << " of the sequence from 1");
    const metric_tensor p = tensors.next(), q = tensors.next();
    metric_tensor a = p, b = q;
    const double before = log_distortion(p, q), most = 0.3 * before;
    REQUIRE(clip_distortion(a, b, most));
    CHECK(log_distortion(a, b) <= most);
    CHECK(log_distortion(a, b) >= 0.97 * most);
    CHECK(determinant(a) * determinant(b) == Approx(determinant(p) * determinant(q)).epsilon(1e-6));
    // Each end moves by half of the excess, within the rounding of a step.
    CHECK(log_distortion(a, p) <= 0.51 * (before - 0.98 * most) + 1e-6);
    CHECK(log_distortion(b, q) <= 0.51 * (before - 0.98 * most) + 1e-6);
    CHECK_FALSE(clip_distortion(a, b, most));
  }
}

TEST_CASE("distortion is the greatest ratio in which two tensors measure a length") {
  CHECK(log_distortion({4, 0, 1}, {1, 0, 1}) == Approx(std::log(2)));
  CHECK(log_distortion({1, 0, 1}, {1, 0, 1.0 / 16}) == Approx(std::log(4)));
  tensor_sequence tensors(2);
  for (int i = 0; i < 200; ++i) {
    const metric_tensor a = tensors.next(), b = tensors.next();
    const double most = log_distortion(a, b);
    CHECK(log_distortion(b, a) == Approx(most).epsilon(1e-6));
    const point u{std::cos(0.1 * i), std::sin(0.1 * i)};
    const auto square = [&u](const metric_tensor& m) {
      return m.m11 * u.x * u.x + 2 * m.m12 * u.x * u.y + m.m22 * u.y * u.y;
    };
    CHECK(std::abs(std::log(square(a) / square(b))) / 2 <= most * (1 + 1e-6));
  }
}

TEST_CASE("what is alike enough keeps every bit") {
  std::vector<point> places;
  std::vector<graph_edge> edges;
  std::vector<metric_tensor> tensors;
  for (vertex_index i = 0; i < 50; ++i) {
    places.push_back({0.7 * i, 0});
    tensors.push_back({1.0 + 0.01 * i, 0.001 * i, 1});
    if (i > 0) edges.push_back({i - 1, i});
  }
  const std::vector<metric_tensor> before = tensors;
  CHECK(grade(places, edges, {}, tensors) == 1);
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(identical(before[i], tensors[i]));
}

TEST_CASE("a graph of wild tensors is graded in few rounds, and the same way each time") {
  constexpr vertex_index side = 20;
  std::vector<point> places;
  std::vector<graph_edge> edges;
  std::vector<metric_tensor> tensors;
  tensor_sequence sequence(3);
  for (vertex_index i = 0; i < side * side; ++i) {
    places.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
    tensors.push_back(sequence.next());
    if (i % side > 0) edges.push_back({i - 1, i});
    if (i >= side) edges.push_back({i - side, i});
  }
  gradation_limit limit;
  limit.distortion = 2;
  std::vector<metric_tensor> again = tensors;
  const std::size_t rounds = grade(places, edges, limit, tensors);
  CHECK(rounds <= limit.most_rounds);
  grade(places, edges, limit, again);
  for (std::size_t i = 0; i < tensors.size(); ++i) CHECK(identical(tensors[i], again[i]));
  for (const graph_edge& e : edges)
    CHECK(log_distortion(tensors[e.a], tensors[e.b]) <= std::log(2) * limit.longest * (1 + 1e-9));
}

TEST_CASE("the coarser end of an edge takes its part of the excess, in each direction by itself") {
  // The first tensor is finer along x, the second along y.
  metric_tensor a{1e4, 0, 1}, b{1, 0, 1e4};
  const double whole = std::log(100), most = std::log(2), excess = whole - 0.98 * most;
  REQUIRE(clip_distortion(a, b, most, 0.7));
  CHECK(std::log(1e4 / a.m11) / 2 == Approx(0.3 * excess).epsilon(1e-9));
  CHECK(std::log(a.m22) / 2 == Approx(0.7 * excess).epsilon(1e-9));
  CHECK(std::log(b.m11) / 2 == Approx(0.7 * excess).epsilon(1e-9));
  CHECK(std::log(1e4 / b.m22) / 2 == Approx(0.3 * excess).epsilon(1e-9));
}

TEST_CASE("a graph that uneven shares have not graded in time is graded by halves") {
  std::vector<point> places;
  std::vector<graph_edge> edges;
  std::vector<metric_tensor> tensors;
  tensor_sequence sequence(4);
  for (vertex_index i = 0; i < 60; ++i) {
    places.push_back({static_cast<double>(i), 0});
    tensors.push_back(sequence.next());
    if (i > 0) edges.push_back({i - 1, i});
  }
  gradation_limit limit;
  limit.uneven_rounds = 1;
  const std::size_t rounds = grade(places, edges, limit, tensors);
  CHECK(rounds > 2);
  CHECK(rounds <= limit.most_rounds);
}
