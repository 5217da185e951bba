// SPDX-License-Identifier: MIT
//
// Recomputes the constants of the semi-static tier: runs the predicates' own formulas on a number
// that counts roundings. Compares the tier with exact arithmetic where its bounds are tight.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/semi_static_filter.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// The greatest number of factors 1 + delta on a monomial. Doubling is exact.
struct rounding_count {
  int depth = 0;
  rounding_count() = default;
  explicit rounding_count(int) {}
  friend rounding_count deepest(rounding_count a, rounding_count b, int more) {
    rounding_count c;
    c.depth = std::max(a.depth, b.depth) + more;
    return c;
  }
  friend rounding_count operator+(rounding_count a, rounding_count b) { return deepest(a, b, 1); }
  friend rounding_count operator-(rounding_count a, rounding_count b) { return deepest(a, b, 1); }
  friend rounding_count operator*(rounding_count a, rounding_count b) {
    rounding_count c;
    c.depth = a.depth + b.depth + 1;
    return c;
  }
  rounding_count operator-() const { return *this; }
};

using counted_point = basic_point<rounding_count>;
using counted_site = basic_site<rounding_count>;
using counted_metric = basic_metric_tensor<rounding_count>;

double rigorous_factor(int depth) {
  // ((1 + eps)^depth - 1) (1 + eps)^15, the second factor for the computed magnitude and bound.
  return std::expm1(depth * std::log1p(semi_static::eps)) * std::pow(1 + semi_static::eps, 15) *
         (1 + 1e-10);
}

}  // namespace

TEST_CASE("the depths of the semi-static bounds are those of the formulas", "[filter]") {
  const counted_point p;
  const counted_site s;
  CHECK(orientation_value(p, p, p).depth <= semi_static::orientation_depth);
  CHECK(compare_distance_value(s, s, p).depth <= semi_static::compare_distance_depth);
  CHECK(wedge_value(s, p, p).depth <= semi_static::wedge_depth);
  const rounding_count turn = orientation_value(p, p, p);
  CHECK(opposite_angles_value(counted_metric{}, p, p, p, p, turn, turn).depth <=
        semi_static::opposite_angles_depth);
  CHECK(in_circle_value(counted_metric{}, p, p, p, p).depth == semi_static::in_circle_depth);
  const rounding_count steepness =
      (squared_length(s.metric, between(p, p)) - squared_length(s.metric, between(p, p))) +
      squared_length(s.metric, between(p, p));
  CHECK(steepness.depth <= semi_static::steepness_depth);
  const rounding_count slope =
      (squared_length(s.metric, between(p, p)) - squared_length(s.metric, between(p, p))) +
      wedge_value(s, p, p);
  CHECK(slope.depth <= semi_static::steepness_depth);
}

TEST_CASE("the factors cover the depths with room for the computed magnitude", "[filter]") {
  for (const int depth : {2, semi_static::orientation_depth, semi_static::compare_distance_depth,
                          semi_static::wedge_depth, semi_static::steepness_depth,
                          semi_static::opposite_angles_depth, semi_static::in_circle_depth})
    CHECK(semi_static::bound_factor(depth) >= rigorous_factor(depth));
}

TEST_CASE("what the semi-static tier decides is right, one ulp around zero", "[filter]") {
  const exact_kernel exact;
  int decided = 0;
  const metric_tensor m{2, 0.5, 1};
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) {
      const point q{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const auto turn = semi_static::orientation(q, {12, 12}, {24, 24});
      if (turn.certain()) CHECK(turn.value() == exact.orientation(q, {12, 12}, {24, 24}));
      const site v{{0, 0}, m}, w{{1, 1}, m};
      const auto nearer = semi_static::compare_distance(v, w, q);
      if (nearer.certain()) CHECK(nearer.value() == exact.compare_distance(v, w, q));
      decided += turn.certain() + nearer.certain();
      // A point next to the fourth corner of a parallelogram, in a metric in which all four corners
      // are on one circle.
      const point near{1 + i * 0x1p-52, 1 + j * 0x1p-52};
      const auto side = semi_static::in_circle({2, 0, 1}, {0, 0}, {1, 0}, {0, 1}, near);
      if (side.certain())
        CHECK(side.value() == exact.in_circle({2, 0, 1}, {0, 0}, {1, 0}, {0, 1}, near));
      const auto dominant = semi_static::dominates(v, w, q);
      if (dominant.certain()) CHECK(dominant.value() == exact.dominates(v, w, q));
    }
  CHECK(decided < 2 * 81 * 81);  // exact zeros among the questions are never decided
}

TEST_CASE("out of range is undecided, never wrong", "[filter]") {
  const site v{{0, 0}, {1, 0, 1}}, w{{0x1p250, 0}, {1, 0, 1}};
  CHECK_FALSE(semi_static::compare_distance(v, w, {1, 1}).certain());
  CHECK_FALSE(semi_static::orientation({0, 0}, {0x1p-600, 0}, {0, 0x1p-600}).certain());
  CHECK_FALSE(semi_static::orientation({0, 0}, {0x1p1000, 1}, {1, 0x1p1000}).certain());
  CHECK_FALSE(semi_static::is_positive_definite({0x1p-600, 0, 1}).certain());
  const double nan = std::nan("");
  CHECK_FALSE(semi_static::orientation({nan, 0}, {1, 0}, {0, 1}).certain());
}
