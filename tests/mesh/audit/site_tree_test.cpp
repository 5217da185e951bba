// SPDX-License-Identifier: MIT
//
// Tests the search of sites that matter to a star.
#include "asterism/mesh/audit/site_tree.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::audit_detail;
using namespace asterism::test;

namespace {

// True if w is too far from v: if some covector g has g . (w - v) > (|g|_v + max(|g|_v, |g|_w))
// reach. Computes with more digits than the code under test. The ratio of the two sides is that of
// a linear function and a convex one, so that it has one maximum over all directions. It is
// searched by thirds if the covector that points from v to w does not suffice.
bool is_clearly_too_far(const site& v, double reach, const site& w) {
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
      wrong += !is_clearly_too_far(v, reach, sites[w]);
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
    const site_tree tree(sites);
    for (const site& v : sites) {
      const double reach = scale * std::exp(random.real(-5, 0));
      left_out.count(sites, v, reach, [&](auto visit) { tree.visit_near({v, reach}, visit); });
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
    const site_tree tree(sites);
    std::vector<std::size_t> leaves;
    for (std::size_t g = 0; g + 1 < tree.groups().size(); ++g) {
      std::vector<star_extent> stars;
      std::vector<double> reaches;
      for (std::size_t k = tree.groups()[g]; k < tree.groups()[g + 1]; ++k) {
        reaches.push_back(scale * std::exp(random.real(-4, -2)));
        stars.emplace_back(sites[tree.order()[k]], reaches.back());
      }
      tree.gather(stars, leaves);
      for (std::size_t k = 0; k < stars.size(); ++k)
        left_out.count(sites, stars[k].v(), reaches[k],
                       [&](auto visit) { tree.visit_near(leaves, stars[k], visit); });
    }
  }
  CHECK(left_out.wrong == 0);
  CHECK(left_out.all > 1000000);
}

TEST_CASE("a search is passed over only where all sites are too far") {
  const std::uint64_t seed = 36;
  CAPTURE(seed);
  splitmix64 random(seed);
  left_out_sites left_out;
  for (int round = 0; round < 60; ++round) {
    const double offset = round % 4 == 3 ? 1e8 : 0, scale = std::ldexp(1.0, 200 * (round % 5 - 2));
    const auto draw_site = [&] {
      return site{{(offset + random.real(-1, 1)) * scale, random.real(-1, 1) * scale},
                  random_metric(random, round % 3 * 3.0)};
    };
    std::vector<site> sites;
    for (int i = 0; i < 20; ++i) sites.push_back(draw_site());
    const site_tree tree(sites);
    for (int i = 0; i < 200; ++i) {
      const site v = draw_site();
      const double reach = scale * std::exp(random.real(-8, -1));
      if (!tree.may_reach(v, reach)) left_out.count(sites, v, reach, [](auto) {});
    }
    CHECK(tree.may_reach(draw_site(), std::numeric_limits<double>::infinity()));
  }
  CHECK(left_out.wrong == 0);
  CHECK(left_out.all > 10000);
}

TEST_CASE("a tree that takes other metrics finds what a new tree finds") {
  splitmix64 random(37);
  std::vector<site> sites;
  for (int i = 0; i < 500; ++i)
    sites.push_back({{random.real(-1, 1), random.real(-1, 1)}, random_metric(random, 2)});
  site_tree kept(sites);
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < 2 * round; ++i)
      sites[static_cast<std::size_t>(random.real(0, 500))].metric = random_metric(random, 2);
    kept.take_sites(sites);
    const site_tree renewed(sites);
    CHECK(kept.order() == renewed.order());
    for (const site& v : sites) {
      const star_extent star(v, std::exp(random.real(-4, 0)));
      std::vector<vertex_index> of_kept, of_renewed;
      kept.visit_near(star, [&](auto w) { of_kept.push_back(w); });
      renewed.visit_near(star, [&](auto w) { of_renewed.push_back(w); });
      REQUIRE(of_kept == of_renewed);
    }
  }
}

TEST_CASE("a tree that takes moved sites leaves out only sites that are too far") {
  const std::uint64_t seed = 38;
  CAPTURE(seed);
  splitmix64 random(seed);
  left_out_sites left_out;
  for (int round = 0; round < 12; ++round) {
    const auto draw_place = [&] { return point{random.real(-1, 1), random.real(-1, 1)}; };
    std::vector<site> sites;
    for (int i = 0; i < 300; ++i) sites.push_back({draw_place(), random_metric(random, 2)});
    site_tree tree(sites);
    for (int i = 0; i < 30; ++i)
      sites[random.bits() % sites.size()] = {draw_place(), random_metric(random, 2)};
    sites[random.bits() % sites.size()].position.x += round % 3 == 0 ? 1e8 : 1e-3;
    tree.take_sites(sites);
    for (const site& v : sites) {
      const double reach = std::exp(random.real(-5, 0));
      left_out.count(sites, v, reach, [&](auto visit) { tree.visit_near({v, reach}, visit); });
    }
  }
  CHECK(left_out.wrong == 0);
  CHECK(left_out.all > 200000);
}

TEST_CASE("stars stretched a thousandfold in any direction are compared with few sites") {
  for (const double turn : {0.0, 0.4, 1.2, 2.5}) {
    splitmix64 random(35);
    const double c = std::cos(turn), s = std::sin(turn), thin = 1e-6;
    const metric_tensor m{thin * c * c + s * s, (thin - 1) * c * s, thin * s * s + c * c};
    std::vector<site> sites;
    for (int i = 0; i < 2000; ++i) {
      const double along = random.real(-20, 20) * 1000, across = random.real(-20, 20);
      sites.push_back({{c * along - s * across, s * along + c * across}, m});
    }
    const site_tree tree(sites);
    std::size_t visited = 0;
    for (const site& v : sites) tree.visit_near({v, 1.0}, [&](auto) { ++visited; });
    CAPTURE(turn);
    CHECK(visited < 40 * sites.size());
  }
}

TEST_CASE("places of any size leave out no site that is near") {
  for (const double far : {0x1p500, 0x1p1022}) {
    const double thin = 1 / far / far;
    const metric_tensor m{far < 0x1p600 ? thin : 1e-300, 0, far < 0x1p600 ? thin : 1e-300};
    const std::vector<site> sites = {
        {{far, far}, m}, {{far, -far}, m}, {{-far, far}, m}, {{far / 2, far}, m}};
    const site_tree tree(sites);
    std::vector<star_extent> stars;
    for (const site& v : sites) stars.emplace_back(v, 1e200);
    std::vector<std::size_t> leaves;
    tree.gather(stars, leaves);
    for (const star_extent& star : stars) {
      std::size_t seen = 0;
      tree.visit_near(leaves, star, [&](auto) { ++seen; });
      CHECK(seen == sites.size());
    }
  }
}

TEST_CASE("an infinite reach leaves nothing out") {
  std::vector<site> sites;
  for (int i = 0; i < 40; ++i) sites.push_back({{1.0 * i * i, 1.0 * i}, round_metric});
  const site_tree tree(sites);
  std::size_t seen = 0;
  tree.visit_near({sites[3], std::numeric_limits<double>::infinity()}, [&](auto) { ++seen; });
  CHECK(seen == sites.size());
}

namespace {

// A star with a closed fan, its neighbours counter-clockwise.
struct outlined_star {
  vertex_index v;
  std::vector<vertex_index> link;
  std::vector<outline_point> outline;
  bool is_known = true;  // the kite of each gap
};

void add_ray(std::vector<outline_point>& outline, const measured_ray& z) {
  outline.push_back(z.on_bisector());
  outline.push_back({z.way});
}

// Returns the bound of a gap towards its vertex, or if that is not known, balanced.
gap_bound bound_of(const quick_reaches& reaches, const measured_ray& x, const measured_ray& y) {
  const gap_bound bound = reaches.between(x, y);
  return std::isfinite(bound.reach) ? bound : reaches.balanced(x, y);
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
  const quick_reaches reaches(sites[star.v]);
  for (std::size_t i = 0; i < star.link.size(); ++i) {
    const auto z = reaches.ray_to(sites[star.link[i]]),
               next = reaches.ray_to(sites[star.link[(i + 1) % star.link.size()]]);
    const gap_bound bound = bound_of(reaches, z, next);
    add_ray(star.outline, z);
    star.outline.push_back(bound.vertex);
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
    const site_tree tree(sites);
    std::vector<star_extent> extents;
    for (const outlined_star& star : stars)
      if (star.is_known)
        extents.emplace_back(sites[star.v], std::span<const outline_point>(star.outline));
      else
        extents.emplace_back(sites[star.v], std::numeric_limits<double>::infinity());
    std::vector<std::size_t> leaves;
    tree.gather(extents, leaves);
    for (std::size_t i = 0; i < stars.size(); ++i) {
      known += stars[i].is_known;
      std::vector<char> seen(sites.size(), 0), gathered(sites.size(), 0);
      tree.visit_near(extents[i], [&](auto w) { seen[w] = 1; });
      tree.visit_near(leaves, extents[i], [&](auto w) { gathered[w] = 1; });
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
