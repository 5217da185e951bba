// SPDX-License-Identifier: MIT
//
// Named cases, each of which some arithmetic or some shortcut gets wrong. Numbers small enough to
// be checked with pencil and paper; the derivation is beside each.
#include <array>

#include "asterism/tests/property/agreement.hpp"

namespace asterism::property {
namespace {

constexpr metric_tensor euclidean = {1, 0, 1};

// The squared distances from all four agree along Y = 0: v = (0,1), w = (0,-1), x = (0,2),
// y = (0,-1/2), f = X^2 + 1 there. The line is all of the wedge's share of Vor{v,w}.
TEST_CASE("four sites equidistant along a line", "[adversarial]") {
  const site v = {{0, 1}, {1, 0, 1}}, w = {{0, -1}, {1, 0, 1}};
  const site x = {{0, 2}, {1, 0, 0.25}}, y = {{0, -0.5}, {1, 0, 4}};
  for (const auto& s : {std::array{v, w, x}, std::array{v, x, y}, std::array{w, y, v}}) {
    expect_agreement(
        -1, [&](const auto& kernel) { return kernel.voronoi_vertex_count(s[0], s[1], s[2]); }, "");
  }
  expect_agreement(
      -1, [&](const auto& kernel) { return kernel.arc_intersection_count(v, w, x); }, "");
  // w and y are on the same side of the line, which is therefore outside their wedge, and outside
  // that of w and x.
  expect_agreement(
      0, [&](const auto& kernel) { return kernel.arc_intersection_count(w, y, v); }, "");
  expect_agreement(
      false, [&](const auto& kernel) { return kernel.insertion_test(v, w, x, y); }, "");
}

// v is nearer to p, but the segment from v crosses Vor{v,w} twice and the one from w once: a
// metric stretched across (v at the origin sees Y ten times longer) makes w's cell a parabola-like
// tongue between v and p.
TEST_CASE("the dominating site need not be the nearer one", "[adversarial]") {
  const site v = {{0, 0}, {1, 0, 1}}, w = {{2, 1}, {4, 0, 4}};
  const std::array<point, 3> on_a_ray = {point{1, 0.5}, point{2, 1}, point{8, 4}};
  // Nearer to v: f_v = 1.25, f_w = 5. At w itself: w. Beyond: f_v = 80 < f_w = 180, behind w's
  // cell.
  expect_agreement(
      sign::positive, [&](const auto& kernel) { return kernel.dominates(v, w, on_a_ray[0]); }, "");
  expect_agreement(
      sign::negative, [&](const auto& kernel) { return kernel.dominates(v, w, on_a_ray[1]); }, "");
  expect_agreement(
      sign::negative,
      [&](const auto& kernel) { return kernel.compare_distance(v, w, on_a_ray[2]); }, "");
  expect_agreement(
      sign::negative, [&](const auto& kernel) { return kernel.dominates(v, w, on_a_ray[2]); }, "");
}

// The circle |q - (4/3)(2,1)...| of the case above: touching segments are a tie of two counts.
// v = (0,0) Euclidean, w = (3,0) with 4 I: Vor{v,w} is x^2 + y^2 = 4 (x-3)^2 + 4 y^2, the circle
// with centre (4,0) and radius 2. The tangent from v touches it at (3, sqrt 3); with the ellipse
// scaled, y counted by 3, the touching point (3, 1) is rational.
TEST_CASE("on the tangent ray neither dominates", "[adversarial]") {
  const site v = {{0, 0}, {1, 0, 3}}, w = {{3, 0}, {4, 0, 12}};
  const point touching = {3, 1}, beyond = {6, 2}, before = {1.5, 0.5};
  // The segment from v has one common point with the bisector, and so has the segment from w.
  expect_agreement(
      sign::zero, [&](const auto& kernel) { return kernel.compare_distance(v, w, touching); }, "");
  expect_agreement(
      sign::zero, [&](const auto& kernel) { return kernel.dominates(v, w, touching); }, "");
  expect_agreement(
      sign::zero, [&](const auto& kernel) { return kernel.dominates(v, w, beyond); }, "");
  expect_agreement(
      sign::positive, [&](const auto& kernel) { return kernel.dominates(v, w, before); }, "");
  expect_agreement(
      false, [&](const auto& kernel) { return kernel.in_wedge(v, w, touching); }, "");
}

TEST_CASE("encroachment: touching is no", "[adversarial]") {
  const site a = {{-1, 0}, euclidean}, b = {{1, 0}, euclidean};
  // (0,1) is as far from the midpoint of the segment as a and b are.
  const auto encroaches = [&](const site& w, bool expected) {
    expect_agreement(
        expected, [&](const auto& kernel) { return kernel.encroaches(a, b, w); }, "");
  };
  encroaches({{0, 1}, euclidean}, false);
  encroaches({{0, 1}, {1, 0, 1 - 0x1p-53}}, true);
  encroaches({{0, 1 + 0x1p-52}, euclidean}, false);
  encroaches({{0, 1 - 0x1p-53}, euclidean}, true);
  encroaches({{0, -1}, euclidean}, false);
}

// The unit square: (1,1) is the greatest site, so the other diagonal is the edge.
TEST_CASE("the unit square keeps the diagonal without its greatest corner", "[adversarial]") {
  const site a = {{0, 0}, euclidean}, b = {{1, 0}, euclidean}, c = {{1, 1}, euclidean},
             d = {{0, 1}, euclidean};
  const auto edge = [&](const four_sites& s, bool expected) {
    expect_agreement(
        expected, [&](const auto& kernel) { return kernel.edge_test(s[0], s[1], s[2], s[3]); },
        record("edge_test", s));
    expect_agreement(
        false, [&](const auto& kernel) { return kernel.insertion_test(s[0], s[1], s[2], s[3]); },
        record("insertion_test", s));
  };
  edge({b, d, a, c}, true);
  edge({d, b, c, a}, true);
  edge({a, c, b, d}, false);
  edge({c, a, d, b}, false);
}

// The four meet in a point q of the arc of v, w that y sees only through v's cell: next to q, v and
// w dominate over y where y is the nearer one (its segment crosses Vor{v,y} twice). A tie rule that
// takes "farther" for "dominated" answers one thing for (x, y) and another for (y, x).
TEST_CASE("a tie behind a cell", "[adversarial]") {
  const site v = {{-6, 4}, {3, 5, 10}}, w = {{3, -1}, {38, 50, 66}};
  const site x = {{2, 0}, {18, 26, 38}}, y = {{-2, 4}, {18, 10, 6}};
  const auto expect_edge = [](const four_sites& s, bool expected) {
    expect_agreement(
        expected, [&](const auto& kernel) { return kernel.edge_test(s[0], s[1], s[2], s[3]); },
        record("edge_test", s));
  };
  for (const auto& [a, b] : {std::array{v, w}, std::array{w, v}}) {
    expect_edge({a, b, x, y}, false);
    expect_edge({a, b, y, x}, false);
  }
  expect_edge({x, y, v, w}, true);
}

TEST_CASE("a corner moved by one unit in the last place decides the square", "[adversarial]") {
  const site a = {{0, 0}, euclidean}, b = {{1, 0}, euclidean}, d = {{0, 1}, euclidean};
  for (const double away : {0x1p-52, -0x1p-53}) {
    const site c = {{1 + away, 1}, euclidean};
    const bool outside = away > 0;
    expect_agreement(
        outside, [&](const auto& kernel) { return kernel.insertion_test(b, d, a, c); }, "");
    expect_agreement(
        !outside, [&](const auto& kernel) { return kernel.insertion_test(a, c, b, d); }, "");
  }
}

}  // namespace
}  // namespace asterism::property
