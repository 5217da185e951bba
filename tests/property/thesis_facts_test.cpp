// SPDX-License-Identifier: MIT
//
// Statements of the thesis that its algorithms rest on: facts 7 and 8 on territories, which hold
// less generally than they are stated, lemmas 5 and 6 on wedged diagrams, lemma 9 on the order of
// good points around a star. Random cases, exact predicates. docs/math/domination.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "agreement.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/voronoi_exact.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::property {
using namespace internal;
namespace {

const filtered_kernel kernel;

metric_tensor random_metric(random_source& random) {
  metric_tensor m;
  do {
    m = {static_cast<double>(random.integer(1, 40)), static_cast<double>(random.integer(-20, 20)),
         static_cast<double>(random.integer(1, 40))};
  } while (!(m.m11 * m.m22 > m.m12 * m.m12));
  return m;
}

point random_point(random_source& random, int size) {
  return {static_cast<double>(random.integer(-size, size)),
          static_cast<double>(random.integer(-size, size))};
}

site random_site(random_source& random, int size) {
  return {random_point(random, size), random_metric(random)};
}

// True if the open segments ab and cd cross in a point that is an end of neither.
bool cross_properly(const point& a, const point& b, const point& c, const point& d) {
  const auto side = [](const point& p, const point& q, const point& r) {
    return to_int(kernel.orientation(p, q, r));
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Returns the first point on the ray from v in this direction that is equally far from w, rounded.
// None if the ray meets no such point or w does not see it.
std::optional<point> arc_point(const site& v, const site& w, double x, double y) {
  const auto square = [](const metric_tensor& m, double a, double b) {
    return m.m11 * a * a + 2 * m.m12 * a * b + m.m22 * b * b;
  };
  const double dx = w.position.x - v.position.x, dy = w.position.y - v.position.y;
  const double a = square(v.metric, x, y) - square(w.metric, x, y);
  const double h =
      x * (w.metric.m11 * dx + w.metric.m12 * dy) + y * (w.metric.m12 * dx + w.metric.m22 * dy);
  const double c = square(w.metric, dx, dy), e = h * h + a * c;
  if (!(e > 0)) return std::nullopt;
  const double s = (h + std::sqrt(e)) / c;
  if (!(s > 1e-6)) return std::nullopt;
  const point p{v.position.x + x / s, v.position.y + y / s};
  return kernel.in_wedge(v, w, p) ? std::optional(p) : std::nullopt;
}

}  // namespace

// "Once a ray passes into s2's territory, it never returns to s1's": a line may cut a curved
// bisector twice.
TEST_CASE("fact 7 of the thesis does not hold of every ray", "[laws]") {
  const site one{{0, 0}, {1, 0, 1}}, two{{2, 0}, {1, 0, 1.25}};  // the bisector is x = 1 + y^2 / 16
  CHECK(kernel.dominates(one, two, {1.25, -4}) == sign::positive);
  CHECK(kernel.dominates(one, two, {1.25, 0}) == sign::negative);
  CHECK(kernel.dominates(one, two, {1.25, 4}) == sign::positive);
}

TEST_CASE("fact 8 of the thesis does not hold where a view is blocked twice", "[laws]") {
  const site one{{0, 0}, {2, -1, 2}}, two{{-1, 0}, {1, 1, 2}};
  const point p{0, -4}, q{0.5, -1.5};
  CHECK(kernel.dominates(one, two, p) == sign::positive);
  CHECK(kernel.dominates(two, one, q) == sign::positive);
  CHECK(cross_properly(one.position, p, two.position, q));
}

// Checks the weaker statement that remains: territories within what the sites see. Lemma 9 needs
// only that, since its points are on visible arcs.
TEST_CASE("facts 7 and 8 of the thesis hold of rays from a site, as far as it sees", "[laws]") {
  random_source random(8);
  int left = 0, crossed = 0;
  for (int k = 0; k < 40000; ++k) {
    const site one = random_site(random, 8), two = random_site(random, 8);
    const point p = random_point(random, 24), q = random_point(random, 24);
    if (one.position == two.position) continue;
    const auto sees = [](const site& v, const site& w, const point& at) {
      return kernel.dominates(v, w, at) == sign::positive &&
             kernel.compare_distance(v, w, at) == sign::negative;
    };
    const std::array sites{one, two};
    const std::array points{p, q};
    // Along a ray from a site, the site's view, once lost, does not return.
    bool blocked = false;
    for (int i = 1; i <= 16; ++i) {
      const point at{one.position.x + i * (p.x - one.position.x) * 0.125,
                     one.position.y + i * (p.y - one.position.y) * 0.125};
      if (at == one.position) break;
      const bool seen = sees(one, two, at);
      expect(!(blocked && seen), record("dominates", sites, points), "returns");
      left += !seen && !blocked ? 1 : 0;
      blocked = blocked || !seen;
    }
    if (!sees(one, two, p) || !sees(two, one, q)) continue;
    ++crossed;
    expect(!cross_properly(one.position, p, two.position, q), record("dominates", sites, points),
           "cross");
  }
  CHECK(left > 8000);
  CHECK(crossed > 5000);
}

// Lemma 6, and lemma 5, a case of it with which its proof starts. Where all arcs and vertices are
// wedged, no site y is in a triangle a, b, p with p on the arc of a and b. The diagram tested is
// that of a mesh which is proved to be its dual, within the domain. p is a Voronoi vertex or
// between two.
TEST_CASE("lemmas 5 and 6 of the thesis: no site is between an edge and its Voronoi arc",
          "[laws]") {
  for (const char* metric : {"identity", "swirl:3", "swirl:12", "sink:12"}) {
    const domain square = check_domain(asterism::square()).value();
    const auto field = make_metric_field(metric, square.box(), 0.35);
    mesh_options wanted;
    wanted.limit_size = true;
    const mesh m = make_mesh(square, *field.value(), wanted).value().result;
    audit_options options;
    options.check_voronoi = true;
    REQUIRE(audit(m, options).voronoi == voronoi_verdict::proved);
    for (const triangle& t : m.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const site &a = m.sites[t[i]], &b = m.sites[t[(i + 1) % 3]], &c = m.sites[t[(i + 2) % 3]];
        const audit_detail::exact_voronoi_arc arc(a, b);
        const auto vertex = arc.vertex(c);
        REQUIRE(vertex);
        const audit_detail::offset from_a = arc.enclose(*vertex);
        const point q{a.position.x + from_a.x.value(), a.position.y + from_a.y.value()};
        for (const site& y : m.sites) {
          if (y == a || y == b) continue;
          const bool inside =
              kernel.orientation(a.position, b.position, y.position) == sign::positive &&
              kernel.orientation(b.position, q, y.position) == sign::positive &&
              kernel.orientation(q, a.position, y.position) == sign::positive;
          CHECK_FALSE(inside);
        }
      }
  }
}

namespace {

// Returns points of the arc of v and w, of sites x and y outside the triangle v, w, p, that v and w
// dominate over x and y.
std::vector<point> good_points(const site& v, const site& w, const site& x, const site& y) {
  std::vector<point> good;
  for (int k = 0; k < 120; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.25) / 120;
    const auto p = arc_point(v, w, std::cos(angle), std::sin(angle));
    if (!p) continue;
    const auto is_good_for = [&](const site& z) {
      const std::array turns{kernel.orientation(v.position, w.position, z.position),
                             kernel.orientation(w.position, *p, z.position),
                             kernel.orientation(*p, v.position, z.position)};
      const bool outside = std::count(turns.begin(), turns.end(), sign::positive) > 0 &&
                           std::count(turns.begin(), turns.end(), sign::negative) > 0;
      return outside && kernel.dominates(v, z, *p) == sign::positive &&
             kernel.dominates(w, z, *p) == sign::positive;
    };
    if (is_good_for(x) && is_good_for(y)) good.push_back(*p);
  }
  return good;
}

// True if the points are in counter-clockwise order around v, in one turn.
bool turn_once(const point& v, const std::vector<point>& points) {
  double whole = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const point &p = points[i], &q = points[(i + 1) % points.size()];
    double turn = std::atan2(q.y - v.y, q.x - v.x) - std::atan2(p.y - v.y, p.x - v.x);
    if (turn < -1e-9) turn += 2 * std::numbers::pi;
    whole += turn;
  }
  return whole < 2 * std::numbers::pi + 1e-6;
}

}  // namespace

TEST_CASE("lemma 9 of the thesis: good points stand around a star as its sites do", "[laws]") {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> predicates(decided);
  random_source random(9);
  int asked = 0, failed = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<site> sites;
    const bool wild = round % 2 == 0;
    for (int k = 0; k < 9; ++k) {
      site s = random_site(random, 40);
      if (!wild) s.metric = {30.0 + random.integer(0, 20), 1.0 * random.integer(-8, 8), 30.0};
      const auto same = [&](const site& o) { return o.position == s.position; };
      if (std::none_of(sites.begin(), sites.end(), same)) sites.push_back(s);
    }
    const boundary none;
    const site_oracle oracle{sites, none, predicates};
    star s{{{{}, true}}};
    for (vertex_index w = 1; w < sites.size(); ++w) {
      if (s.contains(w)) continue;
      offer(oracle, 0, s, w);
      const auto& ring = s.sectors[0].neighbours;
      if (ring.size() < 3) continue;
      std::vector<std::vector<point>> good;
      for (std::size_t i = 0; i < ring.size(); ++i)
        good.push_back(good_points(sites[0], sites[ring[i]], sites[ring[(i + 1) % ring.size()]],
                                   sites[ring[(i + ring.size() - 1) % ring.size()]]));
      if (std::any_of(good.begin(), good.end(), [](const auto& g) { return g.empty(); })) continue;
      for (int choice = 0; choice < 8; ++choice) {
        std::vector<point> chosen;
        for (const auto& g : good)
          chosen.push_back(
              g[static_cast<std::size_t>(random.integer(0, static_cast<int>(g.size()) - 1))]);
        ++asked;
        failed += turn_once(sites[0].position, chosen) ? 0 : 1;
      }
    }
  }
  CHECK(asked > 3000);
  CHECK(failed == 0);
}

}  // namespace asterism::property
