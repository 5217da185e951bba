// SPDX-License-Identifier: MIT
//
// Bounds of distances of trimming curves are at least the distances of points of these curves. This
// holds also where a curve's polynomials have weights that are not positive beyond their knots.
#include "asterism/mesh/surface_audit/trim_distance.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace asterism;
using namespace asterism::internal;

namespace {

surface unit_square() {
  surface_patch p;
  p.degree_u = 1, p.degree_v = 1, p.count_u = 2, p.count_v = 2;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) p.control.push_back({{x, y, 0}, 1});
  surface s;
  s.patches = {p};
  return s;
}

// Returns an arc of height `height` whose weight is negative beyond its knot, and a straight line.
trim_curve arc_and_line(double height) {
  trim_curve c;
  c.degree = 2;
  c.knots = {0, 0, 0, 1, 1, 2, 2, 2};
  c.control = {{0.1, 0.5, 1}, {0.2, height, 3}, {0.3, 0.5, 1}, {0.6, 0.5, 1}, {0.9, 0.5, 1}};
  return c;
}

}  // namespace

TEST_CASE("no piece of a trimming curve is left out of a bound") {
  const auto pieces = bezier_pieces(unit_square());
  REQUIRE(pieces);
  const auto spans = spans_of(pieces.value(), 1);
  const trim_curve high = arc_and_line(0.9), flat = arc_and_line(0.5);
  const curve_on_patch a{pieces.value(), spans[0], high}, b{pieces.value(), spans[0], flat};
  // In the middle of the arcs v differs by 0.4 times the share of the inner point, which is 1.5 of
  // 2.
  const double gap = trim_gap_above(a, b, false, 1e-9);
  CHECK(gap >= 0.3 - 1e-12);
  CHECK(gap <= 1.06 * 0.3);
  CHECK(trim_gap_above(b, a, false, 1e-9) >= 0.3 - 1e-12);
  const double off = chord_distance_above(a, {0, 1, {0.1, 0.5}, {0.9, 0.5}}, {1, 1}, 1e-9);
  CHECK(off >= 0.3 - 1e-12);
  CHECK(off <= 1.06 * 0.3);
  CHECK(chord_distance_above(b, {0, 1, {0.1, 0.5}, {0.9, 0.5}}, {1, 1}, 1e-9) <= 1e-6);
}

TEST_CASE("a piece between knots that rounding does not tell apart proves nothing") {
  const auto pieces = bezier_pieces(unit_square());
  REQUIRE(pieces);
  const auto spans = spans_of(pieces.value(), 1);
  // Between the two knots the curve jumps by 0.3. Before and after them both curves are the same.
  const auto with_jump = [](double high) {
    trim_curve c;
    c.knots = {0, 0, 1, std::nextafter(1.0, 2.0), 3, 3};
    c.control = {{0.1, 0.5, 1}, {0.3, 0.5, 1}, {0.3, high, 1}, {0.9, 0.5, 1}};
    return c;
  };
  const trim_curve up = with_jump(0.8), straight = with_jump(0.5);
  const curve_on_patch a{pieces.value(), spans[0], up}, b{pieces.value(), spans[0], straight};
  CHECK(trim_gap_above(a, b, false, 1e-9) >= 0.3 - 1e-12);
  CHECK(trim_gap_above(b, a, true, 1e-9) >= 0.3 - 1e-12);
  CHECK(chord_distance_above(a, {0, 1, {0.1, 0.5}, {0.9, 0.5}}, {1, 1}, 1e-9) >= 0.3 - 1e-12);
}
