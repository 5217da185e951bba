// SPDX-License-Identifier: MIT
//
// Point 4 of the auditor: stars of valid meshes are recognised, flipped edges are refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;
using Catch::Contains;

namespace {

// Replaces the edge from (i + 1, j) to (i, j + 1) by the other diagonal of the cell.
void flip(patch& p, int i, int j) {
  const auto t = static_cast<std::size_t>(2 * (i + j * p.n));
  p.m.triangles[t] = {p.at(i, j), p.at(i + 1, j), p.at(i + 1, j + 1)};
  p.m.triangles[t + 1] = {p.at(i, j), p.at(i + 1, j + 1), p.at(i, j + 1)};
}

struct star_counts {
  std::size_t missing = 0, rejected = 0;
};

// Checks stars by their definition: tests every site against every gap, and that each neighbour is
// in the star. For meshes of convex domains, where all sites see each other.
star_counts count_slowly(const mesh& m) {
  const filtered_kernel kernel;
  const auto turn = [&](auto a, auto b, auto c) {
    return kernel.orientation(m.sites[a].position, m.sites[b].position, m.sites[c].position);
  };
  const auto apex = [&](auto a, auto b) {  // apex of the triangle on the left of a -> b
    for (const triangle& t : m.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (t[i] == a && t[(i + 1) % 3] == b) return std::optional(t[(i + 2) % 3]);
    return std::optional<asterism::vertex_index>();
  };
  star_counts counts;
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = t[i], x = t[(i + 1) % 3], y = t[(i + 2) % 3];
      if (apex(y, x))
        for (asterism::vertex_index w = 0; w < m.sites.size(); ++w)
          counts.missing += w != v && w != x && w != y && turn(v, x, w) == sign::positive &&
                            turn(v, w, y) == sign::positive &&
                            kernel.edge_test(m.sites[v], m.sites[w], m.sites[x], m.sites[y]);
      // v's neighbour x stands between y and the apex on the other side.
      const auto before = apex(x, v);
      if (before && turn(v, *before, y) == sign::positive && turn(*before, y, x) != sign::positive)
        counts.rejected += !kernel.edge_test(m.sites[v], m.sites[x], m.sites[*before], m.sites[y]);
    }
  return counts;
}

// Surrounds a star of a mesh near two crossing waves by `rings` copies of its link, each twice as
// large as the one before, with tensors of lengths half as great.
mesh star_in_rings(int rings) {
  const site centre{{-0.0053424969, 0.8893047978}, {77547.568, 6793.419881, 1331.7972863}};
  const std::vector<site> link = {{{-0.0089, 0.8953822204}, {201506.52, 12075.11197, 1048.42910}},
                                  {{-0.0059524, 0.8731189211}, {101220.360, 11085.317, 1901.98125}},
                                  {{-0.0014693, 0.8658291845}, {33546.076, -3.76465389, 3451.496}},
                                  {{-0.0002104, 0.8818969724}, {16073.260, 1238.206457, 6905.158}},
                                  {{-0.0030358, 0.8990023661}, {49186.981, 8890.908833, 3291.7096}},
                                  {{-0.0060204, 0.9161950629}, {137267.256, 9999.8748, 1095.5176}},
                                  {{-0.0082334, 0.9268728909}, {191009.017, 10635.5947, 750.7449}}};
  mesh m;
  m.sites.push_back(centre);
  double scale = 1;
  for (int ring = 0; ring < rings; ++ring, scale *= 2)
    for (const site& s : link) {
      const point from{s.position.x - centre.position.x, s.position.y - centre.position.y};
      m.sites.push_back({{centre.position.x + scale * from.x, centre.position.y + scale * from.y},
                         {s.metric.m11 / (scale * scale), s.metric.m12 / (scale * scale),
                          s.metric.m22 / (scale * scale)}});
    }
  const auto n = static_cast<asterism::vertex_index>(link.size());
  for (asterism::vertex_index i = 0; i < n; ++i) {
    const asterism::vertex_index a = 1 + i, b = 1 + (i + 1) % n;
    m.triangles.push_back({0, a, b});
    for (asterism::vertex_index at = 0; at + n < n * static_cast<unsigned>(rings); at += n) {
      m.triangles.push_back({at + a, at + n + a, at + n + b});
      m.triangles.push_back({at + a, at + n + b, at + b});
    }
    const auto outer = n * static_cast<asterism::vertex_index>(rings - 1);
    m.boundary.push_back({outer + a, outer + b, i});
  }
  return m;
}

}  // namespace

TEST_CASE("stars are judged as without any shortcut, however the metric varies") {
  const std::uint64_t seed = 31;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t missing = 0, rejected = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    patch p = make_patch(5, 0.1);
    for (int flips = 0; flips < round % 4; ++flips)
      flip(p, flips, static_cast<int>(random.bits() % 5));
    if (round % 5 == 4) p = stretched(p, 0x1p20);
    const double stretch = round % 5 == 4 ? 0x1p-20 : 1;
    const double strength = round % 3 == 0 ? 0 : round % 3 == 1 ? 0.3 : 2.3;
    for (site& s : p.m.sites) s.metric = random_metric(random, strength);
    for (site& s : p.m.sites) {
      s.metric.m12 *= stretch;
      s.metric.m22 *= stretch * stretch;
    }
    audit_options everything;
    everything.findings_kept = std::numeric_limits<std::size_t>::max();
    const audit_report report = audit(p.m, everything);
    REQUIRE(report.stars_checked);
    const star_counts slow = count_slowly(p.m);
    REQUIRE(report.found[static_cast<std::size_t>(finding_kind::star_site_missing)] ==
            slow.missing);
    REQUIRE(report.found[static_cast<std::size_t>(finding_kind::star_neighbour_rejected)] ==
            slow.rejected);
    missing += slow.missing;
    rejected += slow.rejected;
  }
  CHECK(missing > 100);
  CHECK(rejected > 100);
}

TEST_CASE("a lattice of ties is judged as without any shortcut") {
  patch p = make_patch(6, 0);
  for (site& s : p.m.sites)
    s.position = {s.position.x - 0.5 * (s.position.y / 0.875), s.position.y};
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    patch q = p;
    for (site& s : q.m.sites) {
      s.position = {s.position.x * scale, s.position.y * scale};
      s.metric = {1 / scale / scale, 0, 1 / scale / scale};
    }
    const audit_report report = audit(q.m, {});
    const star_counts slow = count_slowly(q.m);
    CAPTURE(scale, kinds(report));
    CHECK(report.found[static_cast<std::size_t>(finding_kind::star_site_missing)] == slow.missing);
    CHECK(report.found[static_cast<std::size_t>(finding_kind::star_neighbour_rejected)] ==
          slow.rejected);
  }
}

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

// The metric of the patch turns and grows with the distance from its corner.
void vary(patch& p, double strength) {
  for (site& s : p.m.sites) {
    const double x = s.position.x / 15, y = s.position.y / 15;
    s.metric = {1 + strength * x * x, strength * x * y, 1 + strength * y * y};
  }
}

TEST_CASE("a metric that varies gently keeps the stars, and nobody but neighbours is in reach") {
  patch p = make_patch(10);
  vary(p, 0.2);
  const audit_report report = audit(p.m, {});
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.star_pairs == 0);
}

TEST_CASE(
    "in one metric neighbours suffice, and the auditor by itself finds the same of all pairs") {
  std::size_t pairs = 0;
  for (const double unevenness : {0.0, 0.1, 0.3}) {
    const patch p = make_patch(10, unevenness);
    audit_options alone;
    alone.own_filter_alone = true;
    const audit_report by_neighbours = audit(p.m, {}), by_all = audit(p.m, alone);
    CAPTURE(unevenness, kinds(by_neighbours), kinds(by_all));
    CHECK(by_neighbours.certified == by_all.certified);
    CHECK(by_neighbours.found == by_all.found);
    CHECK((!by_neighbours.certified || by_neighbours.star_pairs == 0));
    pairs += by_all.star_pairs;
  }
  CHECK(pairs > 0);
}

TEST_CASE("an audit by filters alone compares few more sites than one that shares gaps") {
  const mesh m = star_in_rings(24);
  audit_options asked;
  asked.findings_kept = std::numeric_limits<std::size_t>::max();
  audit_options alone = asked;
  alone.own_filter_alone = true;
  const audit_report shared = audit(m, asked), by_itself = audit(m, alone);
  CHECK(by_itself.star_pairs < shared.star_pairs + shared.star_pairs / 20);
  CHECK(by_itself.found == shared.found);
  CHECK(shared.stars_checked);
}

TEST_CASE("a metric that varies more keeps the stars, and few edge tests are needed") {
  patch p = make_patch(10);
  vary(p, 3);
  const audit_report report = audit(p.m, {});
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.star_pairs_tested <= report.star_pairs / 5);
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
  // Vertex 5 is inside the circle of vertex 1's triangle. The boundary edge from vertex 4 to vertex
  // 3 hides it from vertex 1.
  const std::vector<point> points = {{0, -0.5}, {1, 0},    {-1, 0}, {0.5, 2.2},
                                     {-0.9, 1}, {-1.5, 2}, {-2, 1}};
  const mesh m = make_mesh_of(points, {{0, 1, 2}, {2, 1, 3}, {4, 5, 6}});
  const filtered_kernel kernel;
  REQUIRE(kernel.edge_test(m.sites[0], m.sites[4], m.sites[1], m.sites[2]));
  const audit_report report = audit(m, {});
  INFO(kinds(report));
  CHECK(report.certified);
}
