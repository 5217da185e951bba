// SPDX-License-Identifier: MIT
//
// Compares the indices of near sites and boxes with a scan of all.
#include "asterism/mesh/search/site_index.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using asterism::vertex_index;
using asterism::test::splitmix64;

namespace {

struct site_cloud {
  std::string name;
  std::vector<site> sites;
};

// Positive definite, of condition up to about `condition`, in units of length `unit`.
metric_tensor random_tensor(splitmix64& random, double condition, double unit) {
  const double t = random.real(0, 3.2), c = std::cos(t), s = std::sin(t);
  const double large = std::exp(random.real(0, std::log(condition))), small = 1;
  const double scale = 1 / (unit * unit);
  return {scale * (large * c * c + small * s * s), scale * (large - small) * c * s,
          scale * (large * s * s + small * c * c)};
}

template <class Place>
site_cloud cloud(const std::string& name, int count, double unit, Place&& place) {
  splitmix64 random(11);
  site_cloud made{name, {}};
  for (int i = 0; i < count; ++i) {
    const point q = place(random, i);
    made.sites.push_back({q, random_tensor(random, i % 3 == 0 ? 1e8 : 10, unit)});
  }
  return made;
}

std::vector<site_cloud> clouds() {
  constexpr int count = 400;
  const auto uniform = [](splitmix64& r, double scale, const point& offset) {
    const double x = r.real(-1, 1), y = r.real(-1, 1);
    return point{offset.x + scale * x, offset.y + scale * y};
  };
  return {
      cloud("random", count, 0.1, [&](auto& r, int) { return uniform(r, 1, {}); }),
      cloud("grid", count, 1,
            [](auto&, int i) {
              return point{double(i % 20), double(i / 20)};
            }),
      cloud("on a horizontal line", count, 1,
            [](auto&, int i) {
              return point{double(i), 7};
            }),
      cloud("on a diagonal", count, 1,
            [](auto&, int i) {
              return point{double(i), -double(i)};
            }),
      cloud("repeated coordinates", count, 1,
            [](auto& r, int i) {
              return point{double(i % 3), r.real(0, 1)};
            }),
      cloud("an ulp apart", count, 1e-13,
            [](auto&, int i) {
              return point{1 + (i % 20) * 0x1p-52, 1 + (i / 20) * 0x1p-52};
            }),
      cloud("the same place again and again", 40, 1,
            [](auto&, int) {
              return point{3, 4};
            }),
      cloud("far from the origin", count, 1e-6,
            [&](auto& r, int) {
              return uniform(r, 1e-5, {1e8, -1e8});
            }),
      cloud("huge", count, 0x1p398, [&](auto& r, int) { return uniform(r, 0x1p400, {}); }),
      cloud("tiny", count, 0x1p-402, [&](auto& r, int) { return uniform(r, 0x1p-400, {}); }),
  };
}

site_index index_of(const std::vector<site>& sites, const bounding_box& box,
                    site_index::purpose purpose = site_index::purpose::everything) {
  site_index made(box, purpose);
  for (vertex_index w = 0; w < sites.size(); ++w) made.insert(sites, w);
  return made;
}

double length(const site& from, const point& to) { return std::sqrt(squared_distance(from, to)); }

// Returns the sites in the box, each of which must be visited once, in a cluster that has its
// position. Corners of boxes have coordinates of sites, so that the boxes must be closed.
std::vector<vertex_index> in_clusters(const site_cloud& c, const site_index& tree,
                                      const bounding_box& box) {
  std::set<vertex_index> seen, inside;
  tree.visit_clusters(
      c.sites, box, [&](std::span<const point> places, std::span<const vertex_index> which) {
        REQUIRE(places.size() == which.size());
        for (std::size_t i = 0; i < which.size(); ++i) {
          const point& q = c.sites[which[i]].position;
          REQUIRE((places[i].x == q.x && places[i].y == q.y));
          REQUIRE(seen.insert(which[i]).second);
          if (box.low.x <= q.x && q.x <= box.high.x && box.low.y <= q.y && q.y <= box.high.y)
            inside.insert(which[i]);
        }
        return true;
      });
  return {inside.begin(), inside.end()};
}

void check_boxes(const site_cloud& c, const site_index& tree, bool clusters = false) {
  splitmix64 random(5);
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] { return c.sites[random.bits() % c.sites.size()].position; };
    const bounding_box box = box_of(any(), any());
    std::vector<vertex_index> found, expected;
    CHECK(tree.visit_box(c.sites, box.low, box.high, [&](vertex_index w) {
      found.push_back(w);
      return true;
    }));
    for (vertex_index w = 0; w < c.sites.size(); ++w) {
      const point& q = c.sites[w].position;
      if (boxes_meet({q, q}, box)) expected.push_back(w);
    }
    std::sort(found.begin(), found.end());
    REQUIRE(found == expected);
    if (clusters) REQUIRE(in_clusters(c, tree, box) == expected);
  }
}

void check_seeing(const site_cloud& c, const site_index& tree) {
  splitmix64 random(6);
  for (int i = 0; i < 200; ++i) {
    const point q = c.sites[random.bits() % c.sites.size()].position;
    const site& other = c.sites[random.bits() % c.sites.size()];
    const double distance = length(other, q);  // exactly the distance of `other`
    std::set<vertex_index> found;
    tree.visit_seeing(q, distance, [&](vertex_index w) { return found.insert(w).second; });
    for (vertex_index w = 0; w < c.sites.size(); ++w)
      if (length(c.sites[w], q) <= distance) REQUIRE(found.count(w) == 1);
  }
}

long double determinant_of(const metric_tensor& m) {
  return 1.0L * m.m11 * m.m22 - 1.0L * m.m12 * m.m12;
}

// Returns the larger eigenvalue of M_w^-1 M_v, in long doubles.
long double largest_ratio(const metric_tensor& v, const metric_tensor& w) {
  const long double det_w = determinant_of(w);
  const long double det_v = determinant_of(v);
  const long double t =
      (1.0L * w.m22 * v.m11 - 2.0L * w.m12 * v.m12 + 1.0L * w.m11 * v.m22) / det_w / 2;
  return t + std::sqrt(std::max(0.0L, t * t - det_v / det_w));
}

void check_reach(const site_cloud& c, const site_index& tree) {
  splitmix64 random(7);
  for (int i = 0; i < 200; ++i) {
    const site& v = c.sites[random.bits() % c.sites.size()];
    const double far = length(v, c.sites[random.bits() % c.sites.size()].position);
    const double reach = far * random.real(0, 0.5);
    std::set<vertex_index> found;
    tree.visit_reach(c.sites, v, reach, [&](vertex_index w) { return found.insert(w).second; });
    for (vertex_index w = 0; w < c.sites.size(); ++w) {
      const double sigma = static_cast<double>(
          std::sqrt(std::max(1.0L, largest_ratio(v.metric, c.sites[w].metric))));
      const double away = length(v, c.sites[w].position);
      // The scan is rounded too: a site within 1e-6 of the rim may be found or not.
      const bool out = away * (1 + 1e-6) > (1 + sigma) * reach;
      if (!out) REQUIRE(found.count(w) == 1);
    }
  }
}

}  // namespace

TEST_CASE("sites in a box, seeing a place, in reach of a star: none is missed") {
  for (const site_cloud& c : clouds()) {
    INFO(c.name);
    const site_index tree = index_of(c.sites, box_of_sites(c.sites));
    CHECK(tree.size() == c.sites.size());
    check_boxes(c, tree);
    check_seeing(c, tree);
    check_reach(c, tree);
  }
}

TEST_CASE("an index for places alone misses none of them either") {
  for (const site_cloud& c : clouds()) {
    INFO(c.name);
    check_boxes(c, index_of(c.sites, box_of_sites(c.sites), site_index::purpose::places), true);
  }
}

TEST_CASE("an index made for a smaller box still finds the sites outside it") {
  for (const site_cloud& c : clouds()) {
    INFO(c.name);
    const bounding_box whole = box_of_sites(c.sites);
    const site_index tree =
        index_of(c.sites, {whole.low, {whole.low.x / 2 + whole.high.x / 2, whole.high.y}});
    check_boxes(c, tree);
    check_seeing(c, tree);
  }
}

TEST_CASE("an index follows a renumbering of its sites") {
  for (const site_cloud& c : clouds()) {
    INFO(c.name);
    site_index tree = index_of(c.sites, box_of_sites(c.sites));
    site_cloud renumbered = c;
    std::vector<vertex_index> to;
    for (std::size_t w = 0; w < c.sites.size(); ++w) {
      to.push_back(static_cast<vertex_index>((7 * w + 3) % c.sites.size()));
      renumbered.sites[to.back()] = c.sites[w];
    }
    tree.renumber(to);
    check_boxes(renumbered, tree);
  }
}

TEST_CASE("an index narrows its answers, and stops when told to") {
  const site_cloud c = clouds().front();
  const site_index tree = index_of(c.sites, box_of_sites(c.sites));
  std::size_t seen = 0;
  CHECK_FALSE(tree.visit_box(c.sites, {-1, -1}, {1, 1}, [&](vertex_index) { return ++seen < 3; }));
  CHECK(seen == 3);
  std::vector<site> round;
  for (const site& s : c.sites) round.push_back({s.position, {1, 0, 1}});
  const site_index even = index_of(round, box_of_sites(round));
  std::size_t near = 0, all = 0;
  for (const site& v : round)
    even.visit_reach(round, v, 0.1, [&](vertex_index) { return ++near > 0; });
  for (const site& v : round)
    even.visit_reach(round, v, INFINITY, [&](vertex_index) { return ++all > 0; });
  CHECK(all == round.size() * round.size());
  CHECK(near * 4 < all);
  CHECK(even.spacing_near(round[0]) > 0);
  std::size_t clusters = 0;
  const site_index places = index_of(c.sites, box_of_sites(c.sites), site_index::purpose::places);
  CHECK_FALSE(places.visit_clusters(c.sites, box_of_sites(c.sites),
                                    [&](const auto&, const auto&) { return ++clusters < 3; }));
  CHECK(clusters == 3);
  CHECK(site_index().visit_box(round, {}, {}, [](vertex_index) { return false; }));
  CHECK(site_index().visit_clusters(round, {}, [](const auto&, const auto&) { return false; }));
  CHECK(site_index().spacing_near(round[0]) == 0);
}

TEST_CASE("boxes are found after any insertions and removals") {
  for (const site_cloud& c : clouds()) {
    INFO(c.name);
    splitmix64 random(9);
    box_index tree(box_of_sites(c.sites));
    std::vector<bounding_box> boxes;
    std::vector<char> there;
    const auto any = [&] { return c.sites[random.bits() % c.sites.size()].position; };
    for (std::uint32_t i = 0; i < 600; ++i) {
      // Segments: long, short and degenerate ones.
      const point p = any(), q = i % 3 == 0 ? any() : p;
      boxes.push_back(box_of(p, i % 3 == 1 ? point{p.x / 2 + p.x / 2, p.y * 0.999} : q));
      there.push_back(1);
      tree.insert(i, boxes[i]);
      if (i % 2 == 1) {
        const auto gone = static_cast<std::uint32_t>(random.bits() % boxes.size());
        if (there[gone] != 0) tree.remove(gone, boxes[gone]);
        there[gone] = 0;
      }
      if (i % 10 != 9) continue;
      const bounding_box asked = box_of(any(), any());
      std::multiset<std::uint32_t> found;
      CHECK(tree.visit(asked, [&](std::uint32_t item) {
        found.insert(item);
        return true;
      }));
      for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        if (there[b] == 0) REQUIRE(found.count(b) == 0);
        if (there[b] != 0 && boxes_meet(boxes[b], asked)) REQUIRE(found.count(b) == 1);
        REQUIRE(found.count(b) <= 1);
      }
    }
  }
}

TEST_CASE("a cone leaves out only sites outside of it") {
  splitmix64 random(45);
  const filtered_kernel kernel;
  std::size_t outside = 0, left_out = 0;
  for (site_cloud& c : clouds()) {
    INFO(c.name);
    site_index index(box_of_sites(c.sites));
    for (vertex_index w = 0; w < c.sites.size(); ++w) index.insert(c.sites, w);
    const auto any = [&]() -> const site& { return c.sites[random.bits() % c.sites.size()]; };
    for (int round = 0; round < 200; ++round) {
      const site& centre = any();
      const point &v = centre.position, &y = any().position, &x = any().position;
      if (kernel.orientation(v, y, x) != sign::positive) continue;
      std::vector<char> seen(c.sites.size(), 0);
      constexpr double everywhere = std::numeric_limits<double>::infinity();
      CHECK(index.visit_cone(c.sites, centre, everywhere, y, x,
                             [&](vertex_index w) { return seen[w] = 1; }));
      const double reach = std::sqrt(squared_distance(centre, x)) / 2;
      std::vector<char> near(c.sites.size(), 0), both(c.sites.size(), 0);
      index.visit_reach(c.sites, centre, reach, [&](vertex_index w) { return near[w] = 1; });
      index.visit_cone(c.sites, centre, reach, y, x, [&](vertex_index w) { return both[w] = 1; });
      for (vertex_index w = 0; w < c.sites.size(); ++w) {
        const point& q = c.sites[w].position;
        const bool is_inside = kernel.orientation(v, y, q) != sign::negative &&
                               kernel.orientation(v, x, q) != sign::positive;
        if (is_inside) REQUIRE(seen[w] != 0);
        if (is_inside) REQUIRE(both[w] == near[w]);
        REQUIRE(both[w] <= near[w]);
        outside += is_inside ? 0 : 1;
        left_out += seen[w] == 0 ? 1 : 0;
      }
    }
  }
  CHECK(left_out > outside / 2);
}

TEST_CASE("the curve's order is a permutation, and goes from near to near") {
  for (site_cloud& c : clouds()) {
    INFO(c.name);
    const auto less = [](const site& a, const site& b) {
      return std::array{a.position.x, a.position.y, a.metric.m11} <
             std::array{b.position.x, b.position.y, b.metric.m11};
    };
    std::vector<site> sorted = c.sites;
    sort_along_curve(sorted, box_of_sites(c.sites));
    std::vector<site> before = c.sites, after = sorted;
    std::sort(before.begin(), before.end(), less);
    std::sort(after.begin(), after.end(), less);
    const auto same = [&](const site& a, const site& b) { return !less(a, b) && !less(b, a); };
    CHECK(std::equal(before.begin(), before.end(), after.begin(), after.end(), same));
  }
  site_cloud random = clouds().front();
  const auto travelled = [](const std::vector<site>& sites) {
    double sum = 0;
    for (std::size_t i = 1; i < sites.size(); ++i)
      sum += std::hypot(sites[i].position.x - sites[i - 1].position.x,
                        sites[i].position.y - sites[i - 1].position.y);
    return sum;
  };
  const double before = travelled(random.sites);
  sort_along_curve(random.sites, box_of_sites(random.sites));
  CHECK(travelled(random.sites) < before / 4);
}
