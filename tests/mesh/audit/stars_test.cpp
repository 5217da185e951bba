// SPDX-License-Identifier: MIT
//
// Point 4 of the auditor: stars of valid meshes are recognised, flipped edges are refused.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/star_filter.hpp"
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

// Returns a metric with lengths exp(+-strength) along orthogonal axes of random direction.
metric_tensor random_metric(splitmix64& random, double strength) {
  const double angle = random.real(-3.2, 3.2), s = std::sin(angle), t = std::cos(angle);
  const double l = std::exp(random.real(-strength, strength)),
               k = std::exp(random.real(-strength, strength));
  return {l * t * t + k * s * s, (l - k) * s * t, l * s * s + k * t * t};
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

namespace {

// True if w is too far from v: if some covector g has g . (w - v) > (|g|_v + max(|g|_v, |g|_w))
// reach. Computes with more digits than the code under test. The ratio of the two sides is that of
// a linear function and a convex one, so that it has one maximum over all directions. It is
// searched by thirds if the covector that points from v to w does not suffice.
bool is_too_far(const site& v, double reach, const site& w) {
  using real = long double;
  const real dx = w.position.x - v.position.x, dy = w.position.y - v.position.y;
  const auto root_of_dual = [](const metric_tensor& t, real x, real y) {
    const real determinant = real{t.m11} * t.m22 - real{t.m12} * t.m12;
    return std::sqrt((t.m22 * x * x - 2 * t.m12 * x * y + t.m11 * y * y) / determinant);
  };
  const auto quotient = [&](real x, real y) {
    const real own = root_of_dual(v.metric, x, y);
    return (x * dx + y * dy) / (own + std::fmax(own, root_of_dual(w.metric, x, y)));
  };
  const real least = reach * (1 - 1e-9L);
  const metric_tensor& m = v.metric;
  if (quotient(m.m11 * dx + m.m12 * dy, m.m12 * dx + m.m22 * dy) > least) return true;
  const real middle = std::atan2(dy, dx), right_angle = std::acos(real{0});
  real low = middle - right_angle, high = middle + right_angle;
  for (int i = 0; i < 100; ++i) {
    const real p = low + (high - low) / 3, q = high - (high - low) / 3;
    if (quotient(std::cos(p), std::sin(p)) < quotient(std::cos(q), std::sin(q)))
      low = p;
    else
      high = q;
  }
  return quotient(std::cos(low), std::sin(low)) > least;
}

// Counts the sites that searches of a tree leave out, and those of them that are not too far from
// v.
struct left_out_sites {
  std::size_t all = 0, wrong = 0;

  // `search` calls its argument with each site that it does not leave out.
  template <class Search>
  void count(const std::vector<site>& sites, const site& v, double reach, const Search& search) {
    std::vector<char> seen(sites.size(), 0);
    search([&](auto w) { seen[w] = 1; });
    for (std::size_t w = 0; w < sites.size(); ++w) {
      if (seen[w] != 0) continue;
      ++all;
      wrong += !is_too_far(v, reach, sites[w]);
    }
  }
};

}  // namespace

TEST_CASE("the tree leaves out only sites that are too far") {
  const std::uint64_t seed = 32;
  CAPTURE(seed);
  splitmix64 random(seed);
  left_out_sites left_out;
  for (int round = 0; round < 24; ++round) {
    const double offset = round % 4 == 3 ? 1e8 : 0, scale = std::ldexp(1.0, 20 * (round % 5 - 2));
    std::vector<site> sites;
    for (int i = 0; i < 300; ++i)
      sites.push_back({{(offset + random.real(-1, 1)) * scale, random.real(-1, 1) * scale},
                       random_metric(random, round % 3 * 3.0)});
    const audit_detail::site_tree tree(sites);
    for (const site& v : sites) {
      const double reach = scale * std::exp(random.real(-5, 0));
      left_out.count(sites, v, reach, [&](auto visit) { tree.visit_near(v, reach, visit); });
    }
  }
  CHECK(left_out.wrong == 0);
  CHECK(left_out.all > 500000);
}

TEST_CASE("one descent for several stars leaves out only sites that are too far from each") {
  const std::uint64_t seed = 33;
  CAPTURE(seed);
  splitmix64 random(seed);
  left_out_sites left_out;
  std::size_t together = 0, groups = 0, measured = 0, unmeasured = 0;
  for (int round = 0; round < 36; ++round) {
    const double offset = round % 4 == 3 ? 1e8 : 0, scale = std::ldexp(1.0, 200 * (round % 5 - 2));
    // Draws tensors stretched by up to 10^6, either in nearly one direction everywhere or at
    // random.
    const double length = std::pow(10.0, round % 4 * 2), turn = random.real(0, 3);
    std::vector<site> sites;
    for (int i = 0; i < 600; ++i) {
      const double along = random.real(-1, 1) * length, across = random.real(-1, 1);
      const double angle = turn + 0.05 / length * across, c = std::cos(angle), s = std::sin(angle);
      const double thin = 1 / (length * length);
      const metric_tensor same = {thin * c * c + s * s, (thin - 1) * c * s, thin * s * s + c * c};
      sites.push_back(
          {{(offset + c * along - s * across) * scale, (s * along + c * across) * scale},
           round % 3 == 2 ? random_metric(random, 2) : same});
    }
    const audit_detail::site_tree tree(sites);
    std::vector<std::size_t> leaves;
    audit_detail::site_tree::nearby_sites nearby;
    for (std::size_t g = 0; g + 1 < tree.groups().size(); ++g) {
      std::vector<audit_detail::site_tree::reaching> stars;
      for (std::size_t i = tree.groups()[g]; i < tree.groups()[g + 1]; ++i)
        stars.push_back({sites[tree.order()[i]], scale * std::exp(random.real(-4, -2))});
      ++groups;
      if (!tree.gather(stars, leaves)) continue;
      ++together;
      // Leaves beyond the limit end a descent.
      if (g % 16 == 0) CHECK((leaves.size() <= 1 || !tree.gather(stars, nearby, 1)));
      REQUIRE(tree.gather(stars, nearby, sites.size()));
      for (const audit_detail::site_tree::reaching& star : stars) {
        const site& v = star.v;
        const double reach = star.reach;
        left_out.count(sites, v, reach,
                       [&](auto visit) { tree.visit_near(leaves, v, reach, visit); });
        // Asks also for a smaller reach, by the distances that the search returns.
        const double less = reach * random.real(0.1, 1);
        bool is_measured = false;
        for (const double asked : {reach, less})
          left_out.count(sites, v, asked, [&](auto visit) {
            is_measured = tree.visit_near(nearby, v, reach, [&](auto w, double squared) {
              if (!audit_detail::site_tree::is_too_far_by(squared, asked)) visit(w);
            });
            if (!is_measured) tree.visit_near(leaves, v, reach, visit);
          });
        (is_measured ? measured : unmeasured) += 1;
      }
    }
  }
  CHECK(left_out.wrong == 0);
  CHECK(left_out.all > 1000000);
  CHECK(2 * together > groups);
  CHECK(together < groups);
  CHECK(measured > 5000);
  CHECK(unmeasured > 0);
}

TEST_CASE("an infinite reach leaves nothing out") {
  std::vector<site> sites;
  for (int i = 0; i < 40; ++i) sites.push_back({{1.0 * i * i, 1.0 * i}, round_metric});
  const audit_detail::site_tree tree(sites);
  std::size_t seen = 0;
  tree.visit_near(sites[3], std::numeric_limits<double>::infinity(), [&](auto) { ++seen; });
  CHECK(seen == sites.size());
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

TEST_CASE("a middle direction along which a neighbour is never met bounds no reach") {
  const site v{{0.021824585749476474, -0.048365284798181613},
               {0.30445532595024566, -0.011046073896418625, 0.32305103897580789}};
  const site w{{2.8253168640733044, 4.4693916536858662},
               {3.531625813788239, -0.82149189262108435, 5.5989245846161833}};
  const site x{{0.60795990606248984, 0.17983712758803594},
               {4.9200461877662161, -2.8997255021004347, 2.0344296834466702}};
  const site y{{-0.88837472957907049, 0.64296693826375129},
               {6.2945098004754723, -2.3268538241074355, 1.049069106753779}};
  REQUIRE(filtered_kernel().edge_test(v, w, x, y));
  const std::vector<site> alone = {w};
  const double reach = audit_detail::star_gap_filter(v, x, y).reach();
  bool found = false;
  audit_detail::site_tree(alone).visit_near(v, reach,
                                            [&](asterism::vertex_index) { found = true; });
  CHECK(found);
}

namespace {

// Returns the sites, in hexadecimal numbers, so that a case can be repeated.
std::string sites_text(const std::vector<site>& sites) {
  std::string text;
  for (const auto& [q, m] : sites)
    for (const double value : {q.x, q.y, m.m11, m.m12, m.m22}) {
      std::array<char, 32> digits;
      std::snprintf(digits.data(), digits.size(), "%a ", value);
      text += digits.data();
    }
  return text;
}

// A star with a closed fan, its neighbours counter-clockwise.
struct outlined_star {
  vertex_index v;
  std::vector<vertex_index> link;
  audit_detail::star_outline outline;
  bool is_known = true;  // the kite of each gap
};

void add_ray(audit_detail::star_outline& outline, const audit_detail::measured_ray& z) {
  outline.add_neighbour(z.way, {{z.share * z.way.x, z.share * z.way.y}, z.on_way});
}

// Returns the bound of a gap towards its vertex, or if that is not known, midway.
audit_detail::gap_bound bound_of(const audit_detail::quick_reaches& reaches,
                                 const audit_detail::measured_ray& x,
                                 const audit_detail::measured_ray& y) {
  const audit_detail::gap_bound bound = reaches.between(x, y);
  return std::isfinite(bound.reach) ? bound : reaches.midway(x, y);
}

// True if w is certainly outside of the outline of the gap from x to y.
bool is_outside_kite(const site& v, const site& x, const site& y, const site& w) {
  const audit_detail::quick_reaches reaches(v);
  const audit_detail::measured_ray to_x = reaches.ray_to(x), to_y = reaches.ray_to(y);
  const audit_detail::gap_bound bound = bound_of(reaches, to_x, to_y);
  if (!std::isfinite(bound.reach)) return false;
  audit_detail::star_outline outline;
  outline.add_vertex(bound.vertex);
  add_ray(outline, to_x);
  add_ray(outline, to_y);
  const point d{w.position.x - v.position.x, w.position.y - v.position.y};
  return outline.excludes({d, d}, {w.metric});
}

// Adds a star to the sites: neighbours all around, at distances that differ up to eightfold.
outlined_star add_star(std::vector<site>& sites, splitmix64& random,
                       const std::function<metric_tensor()>& draw_metric) {
  constexpr int neighbours = 7;
  outlined_star star{static_cast<vertex_index>(sites.size()), {}, {}};
  const point v{random.real(-1, 1), random.real(-1, 1)};
  sites.push_back({v, draw_metric()});
  for (int i = 0; i < neighbours; ++i) {
    const double angle = 0.9 * (i + random.real(0, 0.6)), length = random.real(0.05, 0.4);
    star.link.push_back(static_cast<vertex_index>(sites.size()));
    sites.push_back(
        {{v.x + length * std::cos(angle), v.y + length * std::sin(angle)}, draw_metric()});
  }
  const audit_detail::quick_reaches reaches(sites[star.v]);
  for (std::size_t i = 0; i < star.link.size(); ++i) {
    const auto z = reaches.ray_to(sites[star.link[i]]),
               next = reaches.ray_to(sites[star.link[(i + 1) % star.link.size()]]);
    const audit_detail::gap_bound bound = bound_of(reaches, z, next);
    add_ray(star.outline, z);
    star.outline.add_vertex(bound.vertex);
    star.is_known = star.is_known && std::isfinite(bound.reach);
  }
  return star;
}

// Counts sites that are in gaps of stars: how many of them are accepted, and how many a search left
// out. Requires that none is both.
struct searched_gaps {
  std::size_t accepted = 0, left_out = 0;

  void count(const std::vector<site>& sites, const outlined_star& star,
             const std::vector<char>& seen) {
    const filtered_kernel kernel;
    const site& v = sites[star.v];
    for (std::size_t i = 0; i < star.link.size(); ++i) {
      const site &x = sites[star.link[i]], &y = sites[star.link[(i + 1) % star.link.size()]];
      const auto is_left = [&](const site& a, const site& b, const site& c) {
        return kernel.orientation(a.position, b.position, c.position) == sign::positive;
      };
      for (std::size_t w = 0; w < sites.size(); ++w) {
        const site& z = sites[w];
        if (w == star.v || !is_left(v, x, z) || !is_left(v, z, y) || !is_left(x, z, y)) continue;
        const bool is_accepted = kernel.edge_test(v, z, x, y);
        accepted += is_accepted;
        left_out += seen[w] == 0;
        INFO("edge_test " << sites_text({v, z, x, y}));
        REQUIRE_FALSE((is_accepted && seen[w] == 0));
      }
    }
  }
};

}  // namespace

TEST_CASE("searches by outlines leave out only sites that no gap accepts") {
  const std::uint64_t seed = 34;
  CAPTURE(seed);
  splitmix64 random(seed);
  searched_gaps alone, together;
  std::size_t known = 0;
  for (int round = 0; round < 40; ++round) {
    // Coarse sites beside others up to a hundred times as fine, and tensors of any direction.
    const double strength = 0.5 * (round % 4), fine = round % 2 == 0 ? 1 : 100;
    const auto draw_metric = [&] {
      const metric_tensor m = random_metric(random, strength);
      const double scale = random.real(0, 1) < 0.5 ? fine * fine : 1;
      return metric_tensor{scale * m.m11, scale * m.m12, scale * m.m22};
    };
    std::vector<site> sites;
    std::vector<outlined_star> stars;
    for (int i = 0; i < 12; ++i) stars.push_back(add_star(sites, random, draw_metric));
    const audit_detail::site_tree tree(sites);
    std::vector<audit_detail::site_tree::reaching> reaching;
    for (const outlined_star& star : stars)
      reaching.push_back({sites[star.v], std::numeric_limits<double>::infinity(),
                          star.is_known ? &star.outline : nullptr});
    audit_detail::site_tree::nearby_leaves leaves;
    REQUIRE(tree.gather(reaching, leaves));
    for (std::size_t i = 0; i < stars.size(); ++i) {
      known += stars[i].is_known;
      std::vector<char> seen(sites.size(), 0), gathered(sites.size(), 0);
      tree.visit_near(reaching[i], [&](auto w) { seen[w] = 1; });
      tree.visit_near(leaves, i, [&](auto w) { gathered[w] = 1; });
      alone.count(sites, stars[i], seen);
      together.count(sites, stars[i], gathered);
    }
  }
  CAPTURE(known, alone.left_out, together.left_out, alone.accepted);
  CHECK(known > 100);
  CHECK(alone.left_out > 2000);
  CHECK(together.left_out > 2000);
  CHECK(alone.accepted > 1000);
}

TEST_CASE("the quick exclusions, one by one and by distance, are never wrong") {
  const std::uint64_t seed = 20;
  CAPTURE(seed);
  splitmix64 random(seed);
  const filtered_kernel kernel;
  const auto random_site = [&](double reach, double strength) {
    const metric_tensor metric = random_metric(random, strength);
    return site{{random.real(-reach, reach), random.real(-reach, reach)}, metric};
  };
  int cases = 0, excluded = 0, distant = 0, outlined = 0, accepted = 0;
  for (int i = 0; i < 15000; ++i) {
    const double strength = i % 4 == 0 ? 0 : random.real(0, 3);
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
    const std::vector<site> alone = {w};
    bool far = true;
    audit_detail::site_tree(alone).visit_near(v, filter.reach(),
                                              [&](asterism::vertex_index) { far = false; });
    bool quickly_far = true;
    audit_detail::site_tree(alone).visit_near(v, audit_detail::quick_reach(v, x, y),
                                              [&](asterism::vertex_index) { quickly_far = false; });
    const double reach = star_gap(v, x, y).reach();
    bool beyond = true;
    audit_detail::site_tree(alone).visit_near(v, reach,
                                              [&](asterism::vertex_index) { beyond = false; });
    CAPTURE(i);
    REQUIRE_FALSE((accepts && beyond));
    REQUIRE_FALSE((accepts && excludes));
    REQUIRE_FALSE((accepts && far));
    REQUIRE_FALSE((accepts && quickly_far));
    const bool outside = is_outside_kite(v, x, y, w);
    INFO("edge_test " << sites_text({v, w, x, y}));
    REQUIRE_FALSE((accepts && outside));
    outlined += outside;
    excluded += excludes;
    distant += far && beyond && quickly_far;
    accepted += accepts;
  }
  CAPTURE(cases, excluded, distant, outlined, accepted);
  CHECK(cases > 2000);
  CHECK(outlined > distant);
  CHECK(accepted > 200);
  CHECK(excluded > 300);
  CHECK(distant > 100);
}

TEST_CASE("the quick reach of a gap is about that of the prepared one where metrics vary little") {
  splitmix64 random(21);
  int known = 0, asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const metric_tensor base = random_metric(random, 2);
    const double scale = std::exp2(random.real(-60, 60));
    const auto at = [&](double px, double py) {
      const double factor = random.real(0.97, 1.03);
      return site{{scale * px, scale * py}, {factor * base.m11, base.m12, base.m22}};
    };
    const site v = at(0, 0), x = at(1, random.real(-0.2, 0.2)),
               y = at(random.real(0.2, 0.8), random.real(0.7, 1.1));
    const double wanted = star_gap(v, x, y).reach(), quick = audit_detail::quick_reach(v, x, y);
    CAPTURE(i);
    if (!std::isfinite(wanted)) continue;
    ++asked;
    if (!std::isfinite(quick)) continue;
    const auto half = [&](const site& z) {
      return 0.4999 * std::sqrt(squared_length(v.metric, between(v.position, z.position)));
    };
    CHECK(quick >= std::max(half(x), half(y)));
    known += quick <= 1.25 * wanted;
  }
  CAPTURE(asked, known);
  CHECK(asked > 500);
  CHECK(known > 0.8 * asked);
}

TEST_CASE("no quick reach is known of a gap that doubles cannot tell") {
  const metric_tensor round{1, 0, 1};
  const site v{{0, 0}, round}, x{{1, 0}, round}, y{{0.5, 0.8}, round};
  REQUIRE(std::isfinite(audit_detail::quick_reach(v, x, y)));
  const auto in = [](site s, const metric_tensor& m) { return site{s.position, m}; };
  const metric_tensor thin{1, 1 - 0x1p-40, 1}, large{0x1p320, 0, 0x1p320}, small{0x1p-320, 0, 1};
  for (const metric_tensor& m : {thin, large, small})
    CHECK(std::isinf(audit_detail::quick_reach(in(v, m), in(x, m), in(y, m))));
  const site across{{-1, 0}, round};  // half a turn, and more
  CHECK(std::isinf(audit_detail::quick_reach(v, x, across)));
  CHECK(std::isinf(audit_detail::quick_reach(v, x, {{-0.5, -0.8}, round})));
}
