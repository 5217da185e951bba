// SPDX-License-Identifier: MIT
//
// Exactly cocircular sites: ties are broken alike in every star, so the stars agree as they are.
#include <catch2/catch.hpp>

#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/stars/consistency.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// Lists vertices on the grid's boundary first, counter-clockwise, then the inner ones.
domain grid(int n) {
  std::vector<point> ring;
  ring.reserve(4 * static_cast<std::size_t>(n));
  const int m = n - 1;
  for (int i = 0; i < m; ++i) ring.push_back({1.0 * i, 0});
  for (int i = 0; i < m; ++i) ring.push_back({1.0 * m, 1.0 * i});
  for (int i = 0; i < m; ++i) ring.push_back({1.0 * (m - i), 1.0 * m});
  for (int i = 0; i < m; ++i) ring.push_back({0, 1.0 * (m - i)});
  domain d = polygon(ring);
  for (int i = 1; i < m; ++i)
    for (int j = 1; j < m; ++j) d.vertices.push_back({1.0 * i, 1.0 * j});
  return d;
}

// Returns integer points on one circle around the origin: exactly cocircular, by Pythagorean
// triples.
std::vector<point> points_on_circle(std::int64_t radius, std::size_t wanted) {
  std::vector<point> points;
  for (std::int64_t x = -radius; x <= radius && points.size() < wanted; ++x) {
    const std::int64_t rest = radius * radius - x * x;
    auto y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(rest)));
    while (y * y < rest) ++y;
    if (y * y != rest) continue;
    points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) points.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  return points;
}

std::size_t wide_gaps(const consistency_report& report) {
  return static_cast<std::size_t>(
      std::count_if(report.defects.begin(), report.defects.end(),
                    [](const defect& d) { return d.kind == defect_kind::wide_gap; }));
}

void check_convex_set(const std::vector<site>& sites) {
  const star_setting setting(sites);
  star_set stars;
  stars.construct_all(setting.oracle());
  const consistency_report report = check_consistency(setting.oracle(), stars);
  CHECK(report.disagreeing.empty());
  // Each point on the circle has one wide gap, outside of the circle. The polygon has n - 2
  // triangles.
  CHECK(report.defects.size() == sites.size());
  CHECK(wide_gaps(report) == sites.size());
  CHECK(report.agreeing.size() == sites.size() - 2);
}

}  // namespace

TEST_CASE("a 20 x 20 grid with equal metrics agrees with no site inserted") {
  for (const metric_tensor& m : {metric_tensor{1, 0, 1}, metric_tensor{2, 0.5, 3}}) {
    mesh_options options;
    options.angle_bound = 0;
    const auto made = make_mesh(grid(20), constant_field(m), options);
    REQUIRE(made.ok());
    CHECK(made.value().complete);
    CHECK(made.value().sites == 400);
    CHECK(made.value().triangles == std::size_t{2} * 19 * 19);
    CHECK(made.value().disagreeing == 0);
  }
}

TEST_CASE("an inner star of the grid has an ordinary number of neighbours") {
  const star_setting setting(grid(6));
  const constructed_star built = construct_star(setting.oracle(), 25);
  CHECK(built.settled);
  const std::size_t size = built.content.sectors.at(0).size();
  CHECK(size >= 4);
  CHECK(size <= 8);
}

TEST_CASE("64 points of one circle agree") {
  const std::vector<point> points = points_on_circle(32045, 1000);
  REQUIRE(points.size() >= 64);
  std::vector<site> sites;
  for (std::size_t i = 0; i < 64; ++i) sites.push_back({points[i * points.size() / 64], {1, 0, 1}});
  check_convex_set(sites);
}

TEST_CASE("64 points cocircular in fours agree") {
  // Every four of them (+-a, +-b) share a circle round the origin; the sixteen circles differ.
  std::vector<site> sites;
  for (double k = 1; k <= 16; ++k)
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-1.0, 1.0})
        sites.push_back({{sx * (17 + k), sy * (3 * k * k + 5)}, {1, 0, 1}});
  const star_setting setting(sites);
  star_set stars;
  stars.construct_all(setting.oracle());
  const consistency_report report = check_consistency(setting.oracle(), stars);
  CHECK(report.disagreeing.empty());
}
