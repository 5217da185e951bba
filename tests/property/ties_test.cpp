// SPDX-License-Identifier: MIT
//
// Ties with equal metrics: of four cocircular sites in convex position exactly one diagonal passes,
// from either end, and it is the one without the lexicographically greatest site.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "agreement.hpp"

namespace asterism::property {
namespace {

using four_points = std::array<point, 4>;

// In-circle determinant of points with small integer coordinates: exact in doubles.
bool are_cocircular(const four_points& p) {
  const auto lifted = [&p](std::size_t i) {
    const double x = p[i].x - p[3].x, y = p[i].y - p[3].y;
    return std::array<double, 3>{x, y, x * x + y * y};
  };
  const auto a = lifted(0), b = lifted(1), c = lifted(2);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]) ==
         0;
}

// Cocircular points, no three of them collinear, are in convex position. Their order around the
// centre of gravity is the order along the circle.
void sort_around(four_points& points) {
  double x = 0, y = 0;
  for (const point& p : points) {
    x += p.x / 4;
    y += p.y / 4;
  }
  std::sort(points.begin(), points.end(), [x, y](const point& a, const point& b) {
    return std::atan2(a.y - y, a.x - x) < std::atan2(b.y - y, b.x - x);
  });
}

void expect_one_diagonal(const four_points& around, const metric_tensor& metric) {
  static const filtered_kernel filtered;
  const exact_kernel exact;
  four_sites s;
  for (std::size_t i = 0; i < 4; ++i) s[i] = {around[i], metric};
  const auto greatest = std::max_element(around.begin(), around.end(), lexicographically_less);
  const bool greatest_is_even = (greatest - around.begin()) % 2 == 0;
  const std::string replay = record("edge_test", std::array{s[0], s[2], s[1], s[3]});
  const auto expect_diagonal = [&](std::size_t i, std::size_t j, bool passes) {
    const std::size_t k = (i + 1) % 4, l = (j + 1) % 4;
    expect_equal(passes, exact.edge_test(s[i], s[j], s[k], s[l]), replay, "exact");
    expect_equal(passes, filtered.edge_test(s[i], s[j], s[k], s[l]), replay, "filtered");
    expect_equal(passes, filtered.edge_test(s[j], s[i], s[l], s[k]), replay, "other end");
    expect_equal(false, exact.insertion_test(s[i], s[j], s[k], s[l]), replay, "raw");
  };
  expect_diagonal(0, 2, !greatest_is_even);
  expect_diagonal(1, 3, greatest_is_even);
}

bool no_three_collinear(const four_points& p) {
  const exact_kernel exact;
  return exact.orientation(p[0], p[1], p[2]) != sign::zero &&
         exact.orientation(p[0], p[1], p[3]) != sign::zero &&
         exact.orientation(p[0], p[2], p[3]) != sign::zero &&
         exact.orientation(p[1], p[2], p[3]) != sign::zero;
}

TEST_CASE("ties on a 20 x 20 grid", "[property][ties]") {
  constexpr int block = 4;
  std::vector<point> points;
  points.reserve(16);
  for (int i = 0; i < block; ++i)
    for (int j = 0; j < block; ++j) points.push_back({double(j), double(i)});
  int count = 0;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c)
        for (std::size_t d = c + 1; d < points.size(); ++d) {
          four_points four = {points[a], points[b], points[c], points[d]};
          if (!are_cocircular(four) || !no_three_collinear(four)) continue;
          const double dx = (count * 7) % 17, dy = (count * 11) % 17;  // somewhere on the grid
          for (point& p : four) p = {p.x + dx, p.y + dy};
          sort_around(four);
          expect_one_diagonal(four, {1, 0, 1});
          ++count;
        }
  CHECK(count > 100);
}

// Every unit square of a grid on [-1, 1]^2 with rounded coordinates. A step of 2/19 is no double,
// so that a square is a tie only where rounding made it one. No two answers may contradict each
// other.
TEST_CASE("squares of a rounded grid have exactly one diagonal", "[property][ties]") {
  const exact_kernel exact;
  const auto at = [](int i) { return -1 + i * (2.0 / 19); };
  for (int i = 0; i < 19; ++i)
    for (int j = 0; j < 19; ++j) {
      const metric_tensor m = {1, 0, 1};
      const four_sites s = {site{{at(i), at(j)}, m}, site{{at(i + 1), at(j)}, m},
                            site{{at(i + 1), at(j + 1)}, m}, site{{at(i), at(j + 1)}, m}};
      const bool rising = exact.edge_test(s[0], s[2], s[1], s[3]);
      const bool falling = exact.edge_test(s[1], s[3], s[2], s[0]);
      expect(rising != falling, record("edge_test", std::array{s[0], s[2], s[1], s[3]}),
             "one diagonal exactly");
    }
}

// 1105 = 5 * 13 * 17: its circle has 108 integer points.
TEST_CASE("ties among points of one circle", "[property][ties]") {
  std::vector<point> circle;
  constexpr int radius = 1105;
  for (int x = -radius; x <= radius; ++x) {
    const int rest = radius * radius - x * x;
    const int y = static_cast<int>(std::lround(std::sqrt(rest)));
    if (y * y != rest) continue;
    circle.push_back({double(x), double(y)});
    if (y != 0) circle.push_back({double(x), double(-y)});
  }
  REQUIRE(circle.size() == 108);
  random_source random(41);
  for (int i = 0; i < 300; ++i) {
    four_points four;
    for (point& p : four) p = circle[static_cast<std::size_t>(random.integer(0, 107))];
    sort_around(four);
    if (std::adjacent_find(four.begin(), four.end()) != four.end()) continue;
    const double scale = std::ldexp(1, random.integer(-20, 20));
    // Any multiple of the identity gives the same circle.
    for (point& p : four) p = {scale * p.x, scale * p.y};
    expect_one_diagonal(four, {3, 0, 3});
  }
}

// Mirror images in both axes, in a field with the same symmetries: one tie, in the middle.
TEST_CASE("rectangles around the middle of a symmetric field", "[property][ties]") {
  const exact_kernel exact;
  const filtered_kernel filtered;
  for (const double strength : {3.0, 12.0})
    for (int a = 1; a <= 7; a += 2)
      for (int b = 1; b <= 7; ++b) {
        const auto corner = [&](double x, double y) {
          return site{
              {x / 8, y / 8},
              {1 + strength * x * x / 64, strength * x * y / 64, 1 + strength * y * y / 64}};
        };
        const four_sites s = {corner(-a, -b), corner(a, -b), corner(a, b), corner(-a, b)};
        const std::string replay = record("edge_test", std::array{s[0], s[2], s[1], s[3]});
        if (exact.insertion_test(s[0], s[2], s[1], s[3]) ||
            exact.insertion_test(s[1], s[3], s[2], s[0]))
          continue;  // far enough from round that a diagonal passes at another place
        expect_equal(false, exact.edge_test(s[0], s[2], s[1], s[3]), replay, "through greatest");
        expect_equal(true, exact.edge_test(s[1], s[3], s[2], s[0]), replay, "the other diagonal");
        expect_equal(true, filtered.edge_test(s[3], s[1], s[2], s[0]), replay, "filtered");
      }
}

}  // namespace
}  // namespace asterism::property
