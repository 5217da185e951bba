// SPDX-License-Identifier: MIT
//
// Makes nets of badly placed sites, and checks for every point of a fine grid that a site covers
// it.
#include "asterism/mesh/fill/net_completion.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/named_metric.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

constexpr double covering = 0.75, spacing = 0.69;

// Divides the boundary evenly, and proposes random sites inside.
filled_domain random_proposal(const domain& d, const metric_field& field, std::size_t count,
                              std::uint64_t seed) {
  filled_domain proposed;
  proposed.complete = true;
  const auto divided = divide_segments_evenly(d, field, covering, 0.9, 100000);
  for (const division& one : divided.value().of_each) {
    std::vector<site>& sites = proposed.divisions.emplace_back();
    for (std::size_t i = 1; i + 1 < one.points.size(); ++i)
      sites.push_back({one.points[i], field.at(one.points[i]).value()});
  }
  std::mt19937_64 random(seed);
  const inside_index inside(d);
  const bounding_box box = d.box();
  const auto between = [&](double low, double high) {
    return low + unit_fraction(random()) * (high - low);
  };
  while (proposed.interior.size() < count) {
    const double x = between(box.low.x, box.high.x), y = between(box.low.y, box.high.y);
    if (inside.contains({x, y})) proposed.interior.push_back({{x, y}, field.at({x, y}).value()});
  }
  return proposed;
}

std::vector<site> all_sites(const domain& d, const metric_field& field,
                            const filled_domain& proposed) {
  std::vector<site> all;
  for (const point& v : d.vertices) all.push_back({v, field.at(v).value()});
  for (const std::vector<site>& one : proposed.divisions)
    all.insert(all.end(), one.begin(), one.end());
  all.insert(all.end(), proposed.interior.begin(), proposed.interior.end());
  return all;
}

// Returns the greatest squared distance of a point of a grid inside from its nearest site.
double farthest_squared(const domain& d, const std::vector<site>& sites) {
  constexpr int along = 120;
  const inside_index inside(d);
  const bounding_box box = d.box();
  double farthest = 0;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= along; ++j) {
      const point q{box.low.x + (box.high.x - box.low.x) * i / along,
                    box.low.y + (box.high.y - box.low.y) * j / along};
      if (!inside.contains(q)) continue;
      double nearest = 1e300;
      for (const site& s : sites) nearest = std::min(nearest, squared_distance(s, q));
      farthest = std::max(farthest, nearest);
    }
  return farthest;
}

void check_spacing(const std::vector<site>& all, std::size_t first_inside) {
  for (std::size_t i = first_inside; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(i, j);
      CHECK(std::max(squared_distance(all[i], all[j].position),
                     squared_distance(all[j], all[i].position)) >= spacing * spacing);
    }
}

}  // namespace

TEST_CASE("whatever was proposed, a net covers the domain and keeps its spacing") {
  const std::vector<domain> domains = {
      testing::accepted(testing::polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})),
      testing::accepted(testing::polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2.5}, {0, 2.5}})),
      testing::accepted(testing::polygon({{0, 0}, {2, 0}, {3, 1.4}, {1, 1.6}}))};
  std::uint64_t seed = 7101;
  for (const domain& d : domains)
    for (const char* spec : {"identity", "swirl:0.5", "sink:1"})
      for (const std::size_t count : {0U, 40U, 400U}) {
        CAPTURE(spec, count, seed);
        const auto field = testing::named_metric(spec, d.box(), 0.3);
        filled_domain proposed = random_proposal(d, *field, count, seed++);
        const auto made =
            complete_net(d, *field, {.covering = covering, .spacing = spacing}, proposed);
        REQUIRE(made.ok());
        CHECK(made.value().covered);
        CHECK(proposed.interior.size() + made.value().taken_out == count + made.value().added);
        const std::vector<site> all = all_sites(d, *field, proposed);
        CHECK(farthest_squared(d, all) <= covering * covering);
        check_spacing(all, all.size() - proposed.interior.size());
        // Sites that are a net already stay as they are.
        filled_domain again = proposed;
        const auto same =
            complete_net(d, *field, {.covering = covering, .spacing = spacing}, again);
        CHECK(same.value().taken_out + same.value().added == 0);
      }
}

TEST_CASE("a net without room for its sites says that it does not cover the domain") {
  const domain d = testing::accepted(testing::polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  const auto field = testing::named_metric("identity", d.box(), 0.1);
  filled_domain proposed = random_proposal(d, *field, 0, 1);
  const auto made = complete_net(
      d, *field, {.covering = covering, .spacing = spacing, .max_sites = 120}, proposed);
  REQUIRE(made.ok());
  CHECK_FALSE(made.value().covered);
}
