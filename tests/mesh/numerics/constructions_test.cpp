// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/constructions.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "asterism/mesh/numerics/real_roots.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/poisson_darts.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

class site_generator {
 public:
  explicit site_generator(std::uint64_t seed) : random_(seed) {}
  site next() {
    const double x = 2 * random_.real() - 1, y = 2 * random_.real() - 1;
    const double stretch = 1 + 8 * random_.real(), turn = 3 * random_.real();
    const double c = std::cos(turn), s = std::sin(turn);
    return {{x, y}, {stretch * c * c + s * s, (stretch - 1) * c * s, stretch * s * s + c * c}};
  }

 private:
  splitmix64 random_;
};

bool nearly_equal(double a, double b) { return std::abs(a - b) <= 1e-7 * (a + b); }

constexpr int cells_a_side = 400;
constexpr double cell_width = 8.0 / cells_a_side;

// Returns the points on the sides of the cell with this lower left corner at which f_a - f_other
// changes its sign, by linear interpolation.
std::vector<point> crossings_of_sides(const site& a, const site& other, const point& corner) {
  const auto g = [&](const point& q) {
    return squared_distance(a, q) - squared_distance(other, q);
  };
  const std::array<point, 4> corners{{corner,
                                      {corner.x + cell_width, corner.y},
                                      {corner.x + cell_width, corner.y + cell_width},
                                      {corner.x, corner.y + cell_width}}};
  std::vector<point> found;
  for (std::size_t k = 0; k < 4; ++k) {
    const point p = corners[k], q = corners[(k + 1) % 4];
    const double at_p = g(p), at_q = g(q);
    if ((at_p < 0) == (at_q < 0)) continue;
    const double part = at_p / (at_p - at_q);
    found.push_back({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)});
  }
  return found;
}

// Returns the middles of the small cells of a box in which the bisector of a and b crosses that of
// a and c: each contains a zero of both.
std::vector<point> cells_with_crossings(const site& a, const site& b, const site& c) {
  std::vector<point> cells;
  for (int i = 0; i < cells_a_side; ++i)
    for (int j = 0; j < cells_a_side; ++j) {
      const point corner{-4 + cell_width * i, -4 + cell_width * j};
      const std::vector<point> ends = crossings_of_sides(a, b, corner);
      if (ends.size() != 2) continue;
      const auto nearer = [&](const point& q) {
        return squared_distance(a, q) < squared_distance(c, q);
      };
      if (nearer(ends[0]) != nearer(ends[1]))
        cells.push_back({corner.x + cell_width / 2, corner.y + cell_width / 2});
    }
  return cells;
}

}  // namespace

TEST_CASE("the Voronoi vertex of equal metrics is the circumcentre") {
  const metric_tensor m{1, 0, 1};
  const auto vertices = voronoi_vertices({{0, 0}, m}, {{4, 0}, m}, {{0, 2}, m});
  REQUIRE(vertices.size() == 1);
  CHECK(vertices[0].x == Approx(2));
  CHECK(vertices[0].y == Approx(1));
}

TEST_CASE("Voronoi vertices are equally far from their sites and nearest first") {
  site_generator sites(11);  // seed
  int several = 0;
  for (int i = 0; i < 500; ++i) {
    INFO("triple " << i << " of seed 11");
    const site a = sites.next(), b = sites.next(), c = sites.next();
    const auto vertices = voronoi_vertices(a, b, c);
    CHECK(vertices.size() <= 4);
    several += vertices.size() > 1;
    double last = 0;
    for (const point& q : vertices) {
      const double d = squared_distance(a, q);
      CHECK(nearly_equal(d, squared_distance(b, q)));
      CHECK(nearly_equal(d, squared_distance(c, q)));
      CHECK(d >= last * (1 - 1e-6));
      last = d;
    }
    CHECK(voronoi_vertices(c, a, b) == vertices);
    CHECK(voronoi_vertices(b, a, c) == vertices);
  }
  CHECK(several > 50);
}

TEST_CASE("no Voronoi vertex is missed where the bisectors plainly cross") {
  site_generator sites(5);  // seed
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    INFO("triple " << i << " of seed 5");
    const site a = sites.next(), b = sites.next(), c = sites.next();
    const std::vector<point> found = voronoi_vertices(a, b, c);
    for (const point& cell : cells_with_crossings(a, b, c)) {
      ++compared;
      CHECK(std::any_of(found.begin(), found.end(), [&](const point& q) {
        return std::abs(q.x - cell.x) < cell_width && std::abs(q.y - cell.y) < cell_width;
      }));
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("wedge exits lie on the bisector and on the wedge's border, seen by both") {
  site_generator sites(3);  // seed
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    INFO("pair " << i << " of seed 3");
    const site v = sites.next(), w = sites.next();
    const point d{w.position.x - v.position.x, w.position.y - v.position.y};
    const auto exits = wedge_exits(v, w);
    CHECK(exits.size() <= 2);
    found += static_cast<int>(exits.size());
    for (const point& q : exits) {
      CHECK(nearly_equal(squared_distance(v, q), squared_distance(w, q)));
      const point from_v{q.x - v.position.x, q.y - v.position.y};
      const point from_w{q.x - w.position.x, q.y - w.position.y};
      const double slack = 1e-7 * squared_distance(v, q);
      const double at_v = inner_product(v.metric, from_v, d);
      const double at_w = -inner_product(w.metric, from_w, d);
      CHECK(at_v >= -slack);
      CHECK(at_w >= -slack);
      CHECK(std::min(at_v, at_w) <= slack);
    }
  }
  CHECK(found > 100);
}

TEST_CASE("equal metrics have no wedge exits") {
  const metric_tensor m{3, 1, 2};
  CHECK(wedge_exits({{0, 0}, m}, {{1, 2}, m}).empty());
}

TEST_CASE("a segment is split where its ends are equally far") {
  const site a{{-1, 0}, {4, 0, 1}}, b{{2, 0}, {1, 0, 1}};
  const point m = bisector_point(a, b);
  CHECK(m.x == Approx(0));
  CHECK(m.y == 0);
  CHECK(point_at_distance(a, b.position, 2).x == Approx(0));
}

TEST_CASE("constructions survive extreme scales") {
  for (const double scale : {0x1p-400, 0x1p400}) {
    const metric_tensor m{1 / scale, 0, 1 / scale};
    const auto vertices = voronoi_vertices({{0, 0}, m}, {{4 * scale, 0}, m}, {{0, 2 * scale}, m});
    REQUIRE(vertices.size() == 1);
    CHECK(vertices[0].x == Approx(2 * scale));
  }
}

TEST_CASE("real roots of small polynomials") {
  CHECK(real_roots({-6, 11, -6, 1}).size() == 3);  // 1, 2, 3
  CHECK(real_roots({1, 0, 1}).empty());
  CHECK(real_roots({0, 0, 0}).empty());
  CHECK(real_roots({-4, 2}) == std::vector<double>{2});
  CHECK(quadratic_roots(1, -3, 2) == std::vector<double>{1, 2});
  CHECK(quadratic_roots(0, 2, -4) == std::vector<double>{2});
  CHECK(quadratic_roots(1, 0, 1).empty());
}

TEST_CASE("angles are measured from every vertex, and err towards low") {
  const metric_tensor unit{1, 0, 1}, flat{1, 0, 0.01};
  const point a{0, 0}, b{1, 0}, c{0.5, std::sqrt(3.0) / 2};
  CHECK_FALSE(angle_requirement(59).is_low({{{a, unit}, {b, unit}, {c, unit}}}));
  CHECK_FALSE(angle_requirement(0).is_low({{{a, flat}, {b, unit}, {c, unit}}}));
  for (int turned = 0; turned < 3; ++turned) {
    triangle_sites t{{{a, unit}, {b, unit}, {c, unit}}};
    t[static_cast<std::size_t>(turned)].metric = flat;
    CHECK(angle_requirement(20).is_low(t));
    CHECK(smallest_angle(t) < 20);
  }
  // 45 degrees, as rounded, is not certainly above a bound of 45, and counts as low.
  const triangle_sites right{{{{0, 0}, unit}, {{1, 0}, unit}, {{0, 1}, unit}}};
  CHECK(angle_requirement(45).is_low(right));
  CHECK_FALSE(angle_requirement(44.999).is_low(right));
}

TEST_CASE(
    "angles told by products are never low, near the bound and in metrics that are nearly thin") {
  const std::uint64_t seed = 91;
  CAPTURE(seed);
  splitmix64 random(seed);
  using real = long double;
  std::size_t low = 0, passed = 0;
  for (int k = 0; k < 20'000; ++k) {
    const double bound = std::array{0.1, 1.0, 20.0, 50.0}[static_cast<std::size_t>(k % 4)];
    const double beside = std::pow(10, random.real(-9, -3)) * (k % 8 < 4 ? 1 : -1);
    const double first = bound * (1 + beside) * std::numbers::pi / 180, second = random.real(1, 2);
    // Places a triangle with known angles in the metric L L^T.
    const double l11 = std::exp(random.real(-2, 2)), l22 = std::exp(random.real(-2, 2)),
                 l21 = random.real(-1, 1) * std::pow(10, random.real(-2, 2)) * l22;
    const metric_tensor m{l11 * l11, l11 * l21, l21 * l21 + l22 * l22};
    const double height = 1 / (1 / std::tan(first) + 1 / std::tan(second));
    const auto place = [&](double x, double y) {  // maps by L^-T
      return point{(x - l21 * (y / l22)) / l11, y / l22};
    };
    const triangle_sites t{
        {{place(0, 0), m}, {place(1, 0), m}, {place(height / std::tan(first), height), m}}};
    real smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const point &o = t[i].position, &p = t[(i + 1) % 3].position, &q = t[(i + 2) % 3].position;
      const real ax = real{p.x} - o.x, ay = real{p.y} - o.y, bx = real{q.x} - o.x,
                 by = real{q.y} - o.y;
      const real along = real{m.m11} * ax * bx + real{m.m12} * (ax * by + ay * bx) +
                         real{m.m22} * ay * by,
                 across =
                     std::sqrt(real{m.m11} * m.m22 - real{m.m12} * m.m12) * (ax * by - ay * bx);
      smallest = std::min(smallest, std::atan2(across, along) * 180 / std::numbers::pi_v<real>);
    }
    const bool is_low = angle_requirement(bound).is_low(t);
    CAPTURE(k, bound, beside, static_cast<double>(smallest));
    if (smallest < bound) REQUIRE(is_low);
    low += smallest < bound ? 1 : 0;
    passed += is_low ? 0 : 1;
  }
  CHECK(low > 8'000);
  CHECK(passed > 8'000);
}

TEST_CASE("the corner of the square under the swirl measures acos(K / (1 + K))") {
  const double k = 12;
  const site corner{{1, 1}, swirl_field(k).at({1, 1}).value()};
  const double expected = std::acos(k / (1 + k)) * 180 / 3.14159265358979323846;
  CHECK(corner_angle(corner, {-1, 1}, {1, -1}) == Approx(expected));
}
