// SPDX-License-Identifier: MIT
//
// Point 4 of the auditor: stars of sound meshes are recognised, flipped edges are not.
#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit_site_tree.hpp"
#include "asterism/mesh/audit_star_filter.hpp"
#include "audit_meshes.hpp"

using namespace asterism;
using namespace asterism::test;
using Catch::Contains;

namespace {

// The edge from (i + 1, j) to (i, j + 1) replaced by the other diagonal of the cell.
void flip(patch& p, int i, int j) {
  const auto t = static_cast<std::size_t>(2 * (i + j * p.n));
  p.m.triangles[t] = {p.at(i, j), p.at(i + 1, j), p.at(i + 1, j + 1)};
  p.m.triangles[t + 1] = {p.at(i, j), p.at(i + 1, j + 1), p.at(i, j + 1)};
}

}  // namespace

TEST_CASE("an edge flipped away is missed and the new one refused") {
  patch p = make_patch(6);
  flip(p, 2, 3);
  const audit_report report = audit(p.m, {});
  INFO(kinds(report));
  CHECK(report.stars_checked);
  CHECK_FALSE(report.certified);
  const std::string from = std::to_string(p.at(3, 3) + 1), to = std::to_string(p.at(2, 4) + 1);
  CHECK_THAT(
      witnesses(report, finding_kind::star_site_missing),
      Contains("the star of vertex " + from + " ") && Contains("would accept vertex " + to + " "));
  const std::string end = std::to_string(p.at(2, 3) + 1);
  CHECK_THAT(witnesses(report, finding_kind::star_neighbour_rejected),
             Contains("the star of vertex " + end + " "));
}

TEST_CASE("every single flip is found") {
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      patch p = make_patch(4);
      flip(p, i, j);
      CAPTURE(i, j);
      CHECK_FALSE(audit(p.m, {}).certified);
    }
}

TEST_CASE("without the star check a flip is just another triangulation") {
  patch p = make_patch(4);
  flip(p, 1, 1);
  audit_options options;
  options.check_stars = false;
  const audit_report report = audit(p.m, options);
  CHECK(report.certified);
  CHECK_FALSE(report.stars_checked);
}

TEST_CASE("a metric that varies gently keeps the stars") {
  patch p = make_patch(10);
  for (site& s : p.m.sites) {
    const double x = s.position.x / 15, y = s.position.y / 15;
    s.metric = {1 + 0.2 * x * x, 0.2 * x * y, 1 + 0.2 * y * y};
  }
  const audit_report report = audit(p.m, {});
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.star_pairs_tested < report.star_pairs / 20);
}

TEST_CASE("squares: four cocircular sites have the diagonal of the tie rule") {
  // The greatest of the four, (1, 1), is not on the diagonal.
  const std::vector<point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const mesh kept = make_mesh_of(square, {{0, 1, 3}, {1, 2, 3}});
  const audit_report report = audit(kept, {});
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK_FALSE(audit(make_mesh_of(square, {{0, 1, 2}, {0, 2, 3}}), {}).certified);
}

TEST_CASE("a site that is not seen is not missed") {
  // Vertex 1 would accept vertex 5, inside the circle of its triangle, but for the boundary edge
  // from vertex 4 to vertex 3 between them.
  const std::vector<point> points = {{0, -0.5}, {1, 0},    {-1, 0}, {0.5, 2.2},
                                     {-0.9, 1}, {-1.5, 2}, {-2, 1}};
  const mesh m = make_mesh_of(points, {{0, 1, 2}, {2, 1, 3}, {4, 5, 6}});
  const filtered_kernel kernel;
  REQUIRE(kernel.edge_test(m.sites[0], m.sites[4], m.sites[1], m.sites[2]));
  const audit_report report = audit(m, {});
  INFO(kinds(report));
  CHECK(report.certified);
}

TEST_CASE("the quick exclusions, one by one and by distance, are never wrong") {
  const std::uint64_t seed = 20;
  CAPTURE(seed);
  small_generator random(seed);
  const filtered_kernel kernel;
  const auto random_site = [&](double reach, double strength) {
    const double a = random.between(-strength, strength), b = random.between(-strength, strength);
    const double c = random.between(-3.2, 3.2), s = std::sin(c), t = std::cos(c);
    const double l = std::exp(a), k = std::exp(b);
    return site{{random.between(-reach, reach), random.between(-reach, reach)},
                {l * t * t + k * s * s, (l - k) * s * t, l * s * s + k * t * t}};
  };
  int cases = 0, excluded = 0, distant = 0, accepted = 0;
  for (int i = 0; i < 15000; ++i) {
    const double strength = i % 4 == 0 ? 0 : random.between(0, 3);
    site v = random_site(0.1, strength), x = random_site(1, strength), y = random_site(1, strength);
    const site w = random_site(i % 2 == 0 ? 1.5 : 6, strength);
    if (kernel.orientation(v.position, x.position, y.position) == sign::negative) std::swap(x, y);
    if (kernel.orientation(v.position, x.position, w.position) != sign::positive ||
        kernel.orientation(v.position, w.position, y.position) != sign::positive)
      continue;
    ++cases;
    const bool accepts = kernel.edge_test(v, w, x, y);
    const audit_detail::star_gap_filter filter(v, x, y);
    const bool excludes = filter.excludes(w);
    const bool far = audit_detail::site_tree({w}).near(v, filter.reach()).empty();
    CAPTURE(i);
    REQUIRE_FALSE((accepts && excludes));
    REQUIRE_FALSE((accepts && far));
    excluded += excludes;
    distant += far;
    accepted += accepts;
  }
  CAPTURE(cases, excluded, distant, accepted);
  CHECK(cases > 2000);
  CHECK(accepted > 200);
  CHECK(excluded > 300);
  CHECK(distant > 100);
}
