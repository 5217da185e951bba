// SPDX-License-Identifier: MIT
//
// Recomputes what docs/math/error-constants.md lists beside the depths of filter_bounds_test.cpp:
// how deep the semi-static magnitudes are, what underflow can do to a value in range, and how wide
// the integers of the fixed-width tier become. The predicates' own formulas run on numbers that
// carry the greatest size they can have.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/wedge.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// |value| <= size; `lost` bounds what underflow has done to it: every operation may take 2^-1022
// from its result, and as much from each operand that it reads as zero.
struct sized {
  double size = 0, lost = 0;
  static constexpr double one_underflow = 0x1p-1022;

  friend sized operator+(const sized& a, const sized& b) {
    return {a.size + b.size, a.lost + b.lost + 3 * one_underflow};
  }
  friend sized operator-(const sized& a, const sized& b) { return a + b; }
  friend sized operator*(const sized& a, const sized& b) {
    const double on_a = a.lost + one_underflow, on_b = b.lost + one_underflow;
    return {a.size * b.size, a.size * on_b + b.size * on_a + on_a * on_b + one_underflow};
  }
  sized operator-() const { return *this; }
};

// All coordinates and all metric entries up to these sizes.
struct largest_question {
  basic_point<sized> p;
  basic_metric_tensor<sized> m;
  basic_site<sized> s;
  largest_question(double coordinate, double entry)
      : p{{coordinate, 0}, {coordinate, 0}}, m{{entry, 0}, {entry, 0}, {entry, 0}}, s{p, m} {}

  sized turn() const { return orientation_value(p, p, p); }
  sized wedge() const { return wedge_value(s, p, p); }
  sized difference_of_lengths() const { return compare_distance_value(s, s, p); }
  // A + C and A + H of predicates/domination.hpp.
  sized steepness() const { return difference_of_lengths() + squared_length(m, between(p, p)); }
  sized slope() const { return difference_of_lengths() + wedge(); }
  sized in_circle() const { return in_circle_value(m, p, p, p, p); }
  sized opposite_angles() const { return opposite_angles_value(m, p, p, p, p, turn(), turn()); }
};

// Counts the operations before the root of the computed magnitude.
struct deep {
  int depth = 0;
  friend deep operator+(deep a, deep b) { return {std::max(a.depth, b.depth) + 1}; }
  friend deep operator-(deep a, deep b) { return a + b; }
  // The roundings of both factors add up.
  friend deep operator*(deep a, deep b) { return {a.depth + b.depth + 1}; }
};

}  // namespace

TEST_CASE("computed magnitudes are at most thirteen operations deep", "[filter]") {
  using namespace semi_static;
  const deep operand, difference = operand - operand;
  const deep of_u = difference + difference, of_m = operand + operand;  // |ux| + |uy|, m11 + m22
  const deep squares = difference * difference + difference * difference;
  const deep half_length =
      operand * (difference * difference) + operand * (difference * difference);
  const deep mixed = of_u * (of_u * of_m);
  const deep side = difference * difference + difference * difference;
  const int depths[] = {squares.depth + 1,                  // orientation, four squares
                        (half_length + half_length).depth,  // compare_distance
                        mixed.depth,                        // in_wedge
                        (half_length + half_length + half_length).depth,  // A + C
                        ((half_length + half_length) + mixed).depth,      // A + H
                        (mixed * side + mixed * side).depth,              // opposite angles
                        // in_circle; halves are exact
                        (half_length * side + half_length * side + half_length * side).depth};
  for (const int depth : depths) CHECK(depth <= 13);
  CHECK(depths[5] == 13);  // the 15 of filter_bounds_test: with the factor and the last sum
}

TEST_CASE("in range, underflow takes less than the semi-static bound grants it", "[filter]") {
  using namespace semi_static;
  // Differences are what is kept in range, so coordinates have half the size.
  const largest_question q(largest_operand / 2, largest_operand);
  for (const sized& value : {q.turn(), q.wedge(), q.difference_of_lengths(), q.steepness(),
                             q.slope(), q.opposite_angles(), q.in_circle()}) {
    CHECK(value.lost < 0.5 * smallest_decided);
    CHECK(value.size < 0x1p1020);  // nor does anything overflow
  }
}

TEST_CASE("the integers of the fixed widths fit", "[fixed_width]") {
  const largest_question q(0x1p61, 0x1p61);
  // Greatest sizes of the values stored in 64, 128, 192 and 320 bits, without their sign bits.
  CHECK((q.p.x - q.p.x).size == 0x1p62);
  CHECK(q.turn().size == 0x1p125);
  CHECK(q.wedge().size <= 0x1p188);
  CHECK(q.difference_of_lengths().size <= 0x1p189);
  CHECK(q.steepness().size < 0x1p191);
  CHECK(q.slope().size < 0x1p191);
  CHECK(angle_value(q.m, q.p, q.p, q.p).size * q.turn().size <= 0x1p313);
  // A ray's own metric is the difference of two.
  const auto between_metrics = q.m - q.m;
  CHECK(apply(between_metrics, between(q.p, q.p)).x.size < 0x1p127);
  CHECK(squared_length(between_metrics, between(q.p, q.p)).size <= 0x1p189);
}
