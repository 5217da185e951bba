// SPDX-License-Identifier: MIT
//
// The laws of the predicates about bisectors and arcs, by the numbers that the predicates' headers
// give them.
#include <algorithm>
#include <array>
#include <cmath>

#include "agreement.hpp"
#include "asterism/core/dyadic.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::property {
using namespace internal;
namespace {

const exact_kernel exact;

TEST_CASE("voronoi_vertex_count, law 1: symmetric in all three sites", "[laws]") {
  for_each_case(80, [](const four_sites& sites, random_source&) {
    const auto& [u, v, w, unused] = sites;
    const std::string replay = record("voronoi_vertex_count", {sites.data(), 3});
    const int count = exact.voronoi_vertex_count(u, v, w);
    expect_equal(count, exact.voronoi_vertex_count(u, w, v), replay, "uwv");
    expect_equal(count, exact.voronoi_vertex_count(v, u, w), replay, "vuw");
    expect_equal(count, exact.voronoi_vertex_count(v, w, u), replay, "vwu");
    expect_equal(count, exact.voronoi_vertex_count(w, u, v), replay, "wuv");
    expect_equal(count, exact.voronoi_vertex_count(w, v, u), replay, "wvu");
  });
}

using symmetric_matrix = std::array<dyadic, 6>;  // coefficients of a conic: xx xy yy x y 1

symmetric_matrix conic(const site& u, const site& v) {
  const auto g = distance_difference(convert<dyadic>(u), convert<dyadic>(v));
  const auto half = [](const dyadic& x) { return x.scaled(-1); };
  return {g.form.m11, g.form.m12, g.form.m22, half(g.linear.x), half(g.linear.y), g.constant};
}

bool is_degenerate(const symmetric_matrix& m) {
  const auto& [a, b, c, d, e, f] = m;
  return (a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d)).is_zero();
}

bool are_proportional(const symmetric_matrix& m, const symmetric_matrix& n) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(m[i] * n[j] == m[j] * n[i])) return false;
  return true;
}

// Conics that contain a common line, as all members of their pencil then do: all are degenerate.
TEST_CASE("voronoi_vertex_count, law 2: infinitely many only on a common line or equal conics",
          "[laws]") {
  int infinite = 0;
  for_each_case(150, [&](const four_sites& sites, random_source&) {
    const auto& [u, v, w, unused] = sites;
    if (exact.voronoi_vertex_count(u, v, w) != -1) return;
    ++infinite;
    const auto first = conic(u, v), second = conic(u, w), third = conic(v, w);
    expect((is_degenerate(first) && is_degenerate(second) && is_degenerate(third)) ||
               are_proportional(first, second),
           record("voronoi_vertex_count", {sites.data(), 3}), "-1");
  });
  CHECK(infinite > 50);
}

// The squared distance of (0, h), [a, b/h; ., m/h^2] on the line Y = 0 is a X^2 - 2 b X + m.
TEST_CASE("voronoi_vertex_count, law 2: a common line gives infinitely many", "[laws]") {
  random_source random(24);
  for (int i = 0; i < 300; ++i) {
    const double a = random.integer(2, 5), b = random.integer(-1, 1), m = random.integer(2, 5);
    std::array<site, 3> s;
    for (std::size_t k = 0; k < 3; ++k) {
      const double h =
          std::ldexp(random.chance(2) ? 1 : -1, static_cast<int>(k) + 2 * random.integer(-3, 3));
      s[k] = {{0, h}, {a, b / h, m / (h * h)}};
    }
    if (s[0].position == s[2].position) continue;
    expect_equal(-1, exact.voronoi_vertex_count(s[0], s[1], s[2]),
                 record("voronoi_vertex_count", s), "on a line");
  }
}

TEST_CASE("voronoi_vertex_count, law 3: three equal metrics", "[laws]") {
  for_each_case(80, [](const four_sites& sites, random_source&) {
    four_sites s = sites;
    for (site& of : s) of.metric = sites[0].metric;
    const bool collinear =
        exact.orientation(s[0].position, s[1].position, s[2].position) == sign::zero;
    expect_equal(collinear ? 0 : 1, exact.voronoi_vertex_count(s[0], s[1], s[2]),
                 record("voronoi_vertex_count", {s.data(), 3}), "equal metrics");
  });
}

TEST_CASE("arc_intersection_count, law 1: symmetric in v and w", "[laws]") {
  for_each_case(100, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, unused] = sites;
    expect_equal(exact.arc_intersection_count(v, w, x), exact.arc_intersection_count(w, v, x),
                 record("arc_intersection_count", {sites.data(), 3}), "wvx");
  });
}

TEST_CASE("arc_intersection_count, law 2: at most the number of vertices", "[laws]") {
  for_each_case(100, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, unused] = sites;
    const int vertices = exact.voronoi_vertex_count(v, w, x);
    const int on_arc = exact.arc_intersection_count(v, w, x);
    const std::string replay = record("arc_intersection_count", {sites.data(), 3});
    expect(vertices >= -1 && vertices <= 4 && on_arc >= -1 && on_arc <= 4, replay, "range");
    expect(vertices == -1 || (0 <= on_arc && on_arc <= vertices), replay, "at most the vertices");
  });
}

TEST_CASE("encroaches, law 1: symmetric in a and b", "[laws]") {
  for_each_case(200, [](const four_sites& sites, random_source&) {
    const auto& [a, b, w, unused] = sites;
    expect_equal(exact.encroaches(a, b, w), exact.encroaches(b, a, w),
                 record("encroaches", {sites.data(), 3}), "baw");
  });
}

TEST_CASE("encroaches, law 2: one positive factor keeps the answer", "[laws]") {
  for_each_case(200, [](const four_sites& sites, random_source& random) {
    const auto& [a, b, w, unused] = sites;
    const int exponent = random.integer(-300, 300);
    expect_equal(
        exact.encroaches(a, b, w),
        exact.encroaches(scaled(a, 0, exponent), scaled(b, 0, exponent), scaled(w, 0, exponent)),
        record("encroaches", {sites.data(), 3}), "scaled");
  });
}

TEST_CASE("insertion_test, law 1: symmetric under v <-> w", "[laws]") {
  for_each_case(100, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, y] = sites;
    const std::string replay = record("insertion_test", sites);
    expect_equal(exact.insertion_test(v, w, x, y), exact.insertion_test(w, v, x, y), replay, "wv");
    expect_equal(exact.edge_test(v, w, x, y), exact.edge_test(w, v, x, y), replay, "edge, wv");
  });
}

TEST_CASE("insertion_test, law 2: symmetric under x <-> y", "[laws]") {
  for_each_case(100, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, y] = sites;
    const std::string replay = record("insertion_test", sites);
    expect_equal(exact.insertion_test(v, w, x, y), exact.insertion_test(v, w, y, x), replay, "yx");
    expect_equal(exact.edge_test(v, w, x, y), exact.edge_test(v, w, y, x), replay, "edge, yx");
  });
}

// Law: with x on the left and y on the right of vw there is an edge if and only if y is outside the
// circle of v, w, x.
TEST_CASE("insertion_test, law 3: with equal metrics, the in-circle test", "[laws]") {
  int asked = 0;
  for_each_case(100, [&](const four_sites& sites, random_source&) {
    four_sites s = sites;
    for (site& of : s) of.metric = sites[0].metric;
    const auto at = [&s](std::size_t i) { return convert<dyadic>(s[i].position); };
    if (exact.orientation(s[0].position, s[1].position, s[2].position) != sign::positive) return;
    if (exact.orientation(s[0].position, s[1].position, s[3].position) != sign::negative) return;
    ++asked;
    const sign inside = in_circle(convert<dyadic>(s[0]).metric, at(0), at(1), at(2), at(3)).value();
    expect_equal(inside == sign::negative, exact.insertion_test(s[0], s[1], s[2], s[3]),
                 record("insertion_test", s), "equal metrics");
  });
  CHECK(asked > 300);
}

TEST_CASE("insertion_test and edge_test: a raw yes stays yes", "[laws]") {
  for_each_case(100, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, y] = sites;
    expect(exact.edge_test(v, w, x, y) || !exact.insertion_test(v, w, x, y),
           record("edge_test", sites), "edge_test no where insertion_test is yes");
  });
}

TEST_CASE("tie breaking, law 1: symmetric under v <-> w and x <-> y", "[laws]") {
  int ties = 0;
  for (const char* name : {"cocircular", "grid", "common point", "tangency at common point"}) {
    random_source random(25);
    for (int i = 0; i < 150; ++i) {
      const four_sites sites = draw(kind_named(name), random);
      const auto& [v, w, x, y] = sites;
      const bool answer = exact.edge_test(v, w, x, y);
      ties += answer != exact.insertion_test(v, w, x, y) ? 1 : 0;
      const std::string replay = record("edge_test", sites);
      expect_equal(answer, exact.edge_test(w, v, x, y), replay, "wvxy");
      expect_equal(answer, exact.edge_test(v, w, y, x), replay, "vwyx");
      expect_equal(answer, exact.edge_test(w, v, y, x), replay, "wvyx");
    }
  }
  CHECK(ties > 10);
}

TEST_CASE("tie breaking, law 2: the greatest of four cocircular sites is not on the diagonal",
          "[laws]") {
  int ties = 0;
  random_source random(26);
  for (int i = 0; i < 400; ++i) {
    const four_sites s = draw(kind_named("cocircular"), random);
    const bool passes = exact.edge_test(s[0], s[1], s[2], s[3]);
    if (!passes || exact.insertion_test(s[0], s[1], s[2], s[3])) continue;
    ++ties;
    std::size_t greatest = 0;
    for (std::size_t k = 1; k < 4; ++k)
      if (lexicographically_less(s[greatest].position, s[k].position)) greatest = k;
    expect(greatest >= 2, record("edge_test", s), "the greatest is on the diagonal");
  }
  CHECK(ties > 20);
}

}  // namespace
}  // namespace asterism::property
