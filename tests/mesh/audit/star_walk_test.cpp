// SPDX-License-Identifier: MIT
//
// The walk that spares the auditor's tree: it misses nothing that a star accepts, and settles what
// it is there for.
#include "asterism/mesh/audit/star_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/metric_ball.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::audit_detail;
using namespace asterism::test;

namespace {

// A metric with lengths exp(+-strength) along axes turned by anything.
metric_tensor random_metric(splitmix64& random, double strength) {
  const double angle = random.real(-3.2, 3.2), s = std::sin(angle), t = std::cos(angle);
  const double l = std::exp(random.real(-strength, strength)),
               k = std::exp(random.real(-strength, strength));
  return {l * t * t + k * s * s, (l - k) * s * t, l * s * s + k * t * t};
}

// Replaces the edge from (i + 1, j) to (i, j + 1) by the other diagonal of the cell.
void flip(patch& p, int i, int j) {
  const auto t = static_cast<std::size_t>(2 * (i + j * p.n));
  p.m.triangles[t] = {p.at(i, j), p.at(i + 1, j), p.at(i + 1, j + 1)};
  p.m.triangles[t + 1] = {p.at(i, j), p.at(i + 1, j + 1), p.at(i, j + 1)};
}

// Flips one cell of so many, about.
void flip_some(patch& p, splitmix64& random, std::uint64_t of) {
  for (int j = 0; j < p.n; ++j)
    for (int i = 0; i < p.n; ++i)
      if (random.bits() % of == 0) flip(p, i, j);
}

// The patch without some cells of one row: a domain with a slot, whose sides do not see each other.
mesh with_slot(const patch& p, int row, int first, int last) {
  std::vector<point> points;
  for (const site& s : p.m.sites) points.push_back(s.position);
  std::vector<triangle> triangles;
  for (std::size_t t = 0; t < p.m.triangles.size(); ++t) {
    const int cell = static_cast<int>(t / 2), i = cell % p.n, j = cell / p.n;
    if (j != row || i < first || i >= last) triangles.push_back(p.m.triangles[t]);
  }
  return make_mesh_of(points, triangles);
}

audit_options everything() {
  audit_options options;
  options.findings_kept = std::numeric_limits<std::size_t>::max();
  return options;
}

walk_outcome walked(const mesh& m) {
  audit_report report;
  report.sites = m.sites.size();
  const audit_options options = everything();
  audit_context context(m, options, report);
  check_values(context);
  check_edges(context);
  check_fans(context);
  REQUIRE(report.total_found() == 0);
  const star_surroundings around(context);
  return walk_stars(context, around);
}

// The vertices whose stars would accept another site, as an audit by the tree finds them that
// leaves out whatever the walk has in common with it but the reaches.
std::set<vertex_index> refused(const mesh& m) {
  audit_options options = everything();
  options.own_filter_alone = true;
  const audit_report report = audit(m, options);
  REQUIRE(report.stars_checked);
  std::set<vertex_index> all;
  for (const audit_finding& finding : report.findings)
    if (finding.kind == finding_kind::star_site_missing) all.insert(finding.vertices.at(0));
  return all;
}

struct walk_counts {
  std::size_t refused = 0, left = 0, sites = 0, failed = 0;
};

// Requires that the walk leaves all stars that the tree refuses.
void compare(const mesh& m, walk_counts& counts) {
  const walk_outcome walk = walked(m);
  const std::set<vertex_index> wrong = refused(m);
  counts.refused += wrong.size();
  counts.sites += m.sites.size();
  counts.failed += walk.has_failed ? 1 : 0;
  if (walk.has_failed) return;
  for (const vertex_index v : wrong) {
    CAPTURE(v);
    REQUIRE(walk.is_left[v] != 0);
  }
  for (const char left : walk.is_left) counts.left += left != 0 ? 1 : 0;
}

std::size_t left_by(const walk_outcome& walk) {
  std::size_t left = 0;
  for (const char each : walk.is_left) left += each != 0 ? 1 : 0;
  return left;
}

// The metric of the patch turns and grows with the distance from its corner.
void vary(mesh& m, double strength) {
  for (site& s : m.sites) {
    const double x = s.position.x / 15, y = s.position.y / 15;
    s.metric = {1 + strength * x * x, strength * x * y, 1 + strength * y * y};
  }
}

}  // namespace

TEST_CASE("the walk leaves every star that accepts a site, flips and wild metrics or not") {
  const std::uint64_t seed = 77;
  CAPTURE(seed);
  splitmix64 random(seed);
  walk_counts counts;
  // So many are needed to meet an accepted site that only a listed gap is asked of.
  for (int round = 0; round < 6000; ++round) {
    CAPTURE(round);
    patch p = make_patch(8, 0.1);
    flip_some(p, random, 2 + 8 * (random.bits() % 4));
    const double strength = round % 4 == 3 ? 1.5 : 0.2 * (round % 4);
    for (site& s : p.m.sites) s.metric = random_metric(random, strength);
    compare(p.m, counts);
  }
  CHECK(counts.refused > 500);
  CHECK(counts.failed < 600);
  CHECK(counts.sites - counts.left > 2000);
}

TEST_CASE("the walk leaves every star that accepts a site beside a slot") {
  const std::uint64_t seed = 78;
  CAPTURE(seed);
  splitmix64 random(seed);
  walk_counts counts;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    patch p = make_patch(8, 0.1);
    flip_some(p, random, 10);
    mesh m = with_slot(p, 3 + round % 2, 1 + round % 2, 5 + round % 3);
    const double strength = 0.4 + 0.25 * (round % 4);
    for (site& s : m.sites) s.metric = random_metric(random, strength);
    compare(m, counts);
  }
  CHECK(counts.refused > 200);
  CHECK(counts.failed < 100);
  CHECK(counts.sites - counts.left > 1000);
}

TEST_CASE("the walk settles all stars of a mesh that is good, and asks for no tree") {
  for (const double strength : {0.05, 0.2}) {
    patch p = make_patch(20);
    vary(p.m, strength);
    CAPTURE(strength);
    const walk_outcome walk = walked(p.m);
    CHECK_FALSE(walk.has_failed);
    CHECK(left_by(walk) == 0);
    CHECK(walk.triangles_met < 10 * p.m.sites.size());
  }
}

TEST_CASE("a walk is not begun where balls that all gaps need meet many triangles") {
  patch p = make_patch(40);
  // Edges grow by a factor of 40 from one side to the other: a ball for the long ones meets
  // hundreds of triangles where they are short.
  for (site& s : p.m.sites) {
    s.position = {s.position.x * s.position.x / 40, s.position.y * s.position.y / 40};
    s.metric = {1, 0, 1 + s.position.x * 0x1p-10};
  }
  const walk_outcome walk = walked(p.m);
  CHECK(walk.has_failed);
  CHECK(walk.triangles_met == 0);
  CHECK(walk.listed_gaps == 0);
}

TEST_CASE("one flip leaves the stars around it to the tree, and settles all others") {
  patch p = make_patch(20);
  vary(p.m, 0.2);
  flip(p, 9, 9);
  const walk_outcome walk = walked(p.m);
  REQUIRE_FALSE(walk.has_failed);
  CHECK(walk.is_left[p.at(10, 9)] != 0);
  CHECK(walk.is_left[p.at(9, 10)] != 0);
  CHECK(left_by(walk) <= 12);
}

TEST_CASE("a site whose metric doubles do not tell leaves all to the tree") {
  patch p = make_patch(6);
  vary(p.m, 0.2);
  p.m.sites[p.at(3, 3)].metric = {1, 0.999999999, 1};
  CHECK(walked(p.m).has_failed);
  CHECK(audit(p.m, everything()).stars_checked);
}

TEST_CASE("an audit that walks finds what one by the tree finds") {
  const std::uint64_t seed = 79;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t missing = 0, certified = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    patch p = make_patch(12, 0.05);
    vary(p.m, 0.3);
    // Few stars are refused, so that the tree is asked about those alone.
    if (round % 3 == 1) p.m.sites[p.at(6, 6)].metric = random_metric(random, 2);
    if (round % 3 == 2) p.m.sites[p.at(4, 1 + round / 3 % 9)].metric = random_metric(random, 1);
    audit_options alone = everything();
    alone.own_filter_alone = true;
    const audit_report by_walk = audit(p.m, everything()), by_tree = audit(p.m, alone);
    REQUIRE(by_walk.found == by_tree.found);
    missing += by_tree.found[static_cast<std::size_t>(finding_kind::star_site_missing)];
    certified += by_tree.certified ? 1 : 0;
  }
  CHECK(missing > 10);
  CHECK(certified > 10);
}

TEST_CASE("a ball certainly misses only segments that are farther, and most of these") {
  const std::uint64_t seed = 80;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t missed = 0, farther = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto somewhere = [&] { return point{random.real(-2, 2), random.real(-2, 2)}; };
    const site w{somewhere(), random_metric(random, i % 2 == 0 ? 1.0 : 4.0)};
    const point a = somewhere(), b = somewhere();
    const metric_ball ball(w);
    if (!ball.is_usable()) continue;
    using real = long double;
    const real ax = real{a.x} - w.position.x, ay = real{a.y} - w.position.y, ex = real{b.x} - a.x,
               ey = real{b.y} - a.y;
    const auto product = [&w](real px, real py, real qx, real qy) {
      return px * (w.metric.m11 * qx + w.metric.m12 * qy) +
             py * (w.metric.m12 * qx + w.metric.m22 * qy);
    };
    const real share =
        std::fmin(real{1}, std::fmax(real{0}, -product(ax, ay, ex, ey) / product(ex, ey, ex, ey)));
    const real x = ax + share * ex, y = ay + share * ey;
    const auto distance = static_cast<double>(std::sqrt(product(x, y, x, y)));
    const point p = ball.in_frame(a), q = ball.in_frame(b);
    CAPTURE(i, distance);
    for (const double radius : {0.5 * distance, distance * (1 - 0x1p-16), distance * (1 + 0x1p-22),
                                distance, 2 * distance}) {
      const bool misses = metric_ball::misses(p, q, radius);
      if (misses) REQUIRE(distance > radius);
      missed += misses ? 1 : 0;
      farther += distance > radius ? 1 : 0;
    }
    const point low = ball.low(1), high = ball.high(1);
    if (distance <= 1 && share > 0 && share < 1) {
      const auto at_x = static_cast<double>(w.position.x + x),
                 at_y = static_cast<double>(w.position.y + y);
      REQUIRE((low.x <= at_x && at_x <= high.x && low.y <= at_y && at_y <= high.y));
    }
  }
  CHECK(missed > 9 * farther / 10);
}

TEST_CASE("no accepted site is beyond the extent of its gap, or away from where that is") {
  const std::uint64_t seed = 81;
  CAPTURE(seed);
  splitmix64 random(seed);
  const filtered_kernel kernel;
  std::size_t accepted = 0, inside = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double strength = i % 3 == 0 ? 0.1 : i % 3 == 1 ? 0.5 : 1.5;
    const auto somewhere = [&] {
      return site{{random.real(-1, 1), random.real(-1, 1)}, random_metric(random, strength)};
    };
    const site v = somewhere(), x = somewhere(), y = somewhere(), w = somewhere();
    const auto turn = [&](const site& a, const site& b, const site& c) {
      return kernel.orientation(a.position, b.position, c.position);
    };
    if (turn(v, x, y) != sign::positive || turn(v, x, w) != sign::positive ||
        turn(v, w, y) != sign::positive || turn(x, y, w) != sign::negative)
      continue;
    if (!kernel.edge_test(v, w, x, y)) continue;
    const gap_extent extent = extents_of({&v, &x, &y})[0];
    if (!std::isfinite(extent.reach)) continue;
    CAPTURE(i);
    ++accepted;
    REQUIRE_FALSE(site_tree::is_too_far(v, extent.reach, w));
    const metric_ball ball(w);
    if (!ball.is_usable() || !extent.stays_inside) continue;
    ++inside;
    // The ball of w meets the triangle, so one of its edges, of which w is outside.
    const point a = ball.in_frame(v.position), b = ball.in_frame(x.position),
                c = ball.in_frame(y.position);
    REQUIRE_FALSE((metric_ball::misses(a, b, extent.reach) &&
                   metric_ball::misses(b, c, extent.reach) &&
                   metric_ball::misses(c, a, extent.reach)));
  }
  CHECK(accepted > 1000);
  CHECK(inside > 300);
}
