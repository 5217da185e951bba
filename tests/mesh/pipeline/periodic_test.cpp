// SPDX-License-Identifier: MIT
//
// Periodic sides: which places are partners, and that the auditor, by a computation of its own,
// finds spoiled vertices one by one.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/periodic_mesh.hpp"
#include "asterism/mesh/pipeline/periodic_sides.hpp"
#include "asterism/mesh/support/rational.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// A domain of four sides with markers 1 to 4, beginning with the side from corner a to b.
domain quadrangle(const std::array<point, 4>& corners) {
  domain d;
  d.vertices.assign(corners.begin(), corners.end());
  d.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  auto checked = check_domain(d);
  REQUIRE(checked);
  return checked.value();
}

mesh periodic_square() {
  const auto field = make_metric_field("swirl:6", square().box(), 0.4);
  REQUIRE(field);
  mesh_options options;
  options.limit_size = true;
  const auto made = make_periodic_mesh(square(), *field.value(), options, {{4, 2}, {1, 3}});
  REQUIRE(made);
  REQUIRE(made.value().certified());
  REQUIRE(made.value().claim.periodic.size() == 2);
  return made.value().outcome.result;
}

bool is_sum(double a, double b, double sum) { return rational(a) + rational(b) == rational(sum); }

}  // namespace

TEST_CASE("places of exact sides are exact images, in rationals") {
  constexpr std::uint64_t seed = 20261126;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const auto part = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int trial = 0; trial < 200; ++trial) {
    // The shift is a multiple of 2^-10; the corners are multiples of 2^-20.
    const auto coarse = [&](double step) { return std::nearbyint(part() / step) * step; };
    const point shift{2 + coarse(0x1p-10), coarse(0x1p-10) - 0.5};
    const point a{coarse(0x1p-20), -1 - coarse(0x1p-20)}, d{coarse(0x1p-20), 1 + coarse(0x1p-20)};
    auto sides = periodic_sides::find(
        quadrangle({a, {a.x + shift.x, a.y + shift.y}, {d.x + shift.x, d.y + shift.y}, d}), {4, 2});
    REQUIRE(sides);
    periodic_sides& found = sides.value();
    REQUIRE(found.map().is_exact);
    std::vector<point> places;
    for (int k = 1; k < 20; ++k) {
      const double t = (k + 0.9 * part()) / 21;
      places.push_back({d.x + t * (a.x - d.x), d.y + t * (a.y - d.y)});
    }
    REQUIRE(found.insert(0, places) == places.size());
    REQUIRE(found.map().is_exact);
    for (const side_station& s : found.stations()) {
      CHECK(is_sum(s.first.x, shift.x, s.second.x));
      CHECK(is_sum(s.first.y, shift.y, s.second.y));
    }
  }
}

TEST_CASE("a place without an exact image near it makes the match one by lengths, not a guess") {
  // Coordinates of the second side have far fewer bits after the point than those of the slanted
  // first.
  const double far = 0x1p30;
  auto sides =
      periodic_sides::find(quadrangle({{{0, 0}, {far, 0}, {far + 0.25, 1}, {0.25, 1}}}), {4, 2});
  REQUIRE(sides);
  REQUIRE(sides.value().map().is_exact);
  REQUIRE(sides.value().insert(0, {{0.0875, 0.35}}) == 1);
  const side_station& placed = sides.value().stations()[1];
  if (sides.value().map().is_exact) {
    CHECK(is_sum(placed.first.x, far, placed.second.x));
  } else {
    CHECK_FALSE(is_sum(placed.first.x, far, placed.second.x));
  }
  CHECK(std::abs(placed.first.x - placed.first.y / 4) <= 0x1p-51);
}

TEST_CASE("turns by quarters are found exactly, others by lengths") {
  for (int k = 1; k < 4; ++k) {
    const std::array<std::array<double, 2>, 4> turns = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const double c = turns[static_cast<std::size_t>(k)][0],
                 s = turns[static_cast<std::size_t>(k)][1];
    // The first side leads along the x axis; the second is its image.
    const point a{1, 0}, b{3, 0};
    const auto turned = [&](const point& q) { return point{c * q.x - s * q.y, s * q.x + c * q.y}; };
    domain d;
    d.vertices = {a, b};
    // Lists corners around the outside, then around the inside, with the domain on the left of
    // both.
    for (int step = 1; step < 2 * k; ++step) {
      const double angle = step * 0.78539816339744831;
      d.vertices.push_back({5 * elementary::cos(angle), 5 * elementary::sin(angle)});
    }
    d.vertices.push_back(turned(b));
    d.vertices.push_back(turned(a));
    for (int step = 2 * k - 1; step > 0; --step) {
      const double angle = step * 0.78539816339744831;
      d.vertices.push_back({0.8 * elementary::cos(angle), 0.8 * elementary::sin(angle)});
    }
    const auto n = static_cast<vertex_index>(d.vertices.size());
    for (vertex_index v = 0; v < n; ++v)
      d.segments.push_back({v, (v + 1) % n,
                            v == 0                                      ? 1
                            : v == 2 * static_cast<vertex_index>(k) + 1 ? 2
                                                                        : 9});
    const auto checked = check_domain(d);
    REQUIRE(checked);
    const auto sides = periodic_sides::find(checked.value(), {1, 2});
    REQUIRE(sides);
    CHECK(sides.value().map().is_exact);
    CHECK(sides.value().map().cosine == c);
    CHECK(sides.value().map().sine == s);
  }
}

TEST_CASE("the auditor refuses a match of which one vertex is off by the least there is") {
  const mesh whole = periodic_square();
  REQUIRE(match_periodic(whole, {4, 2}));
  CHECK(match_periodic(whole, {4, 2}).value().kind == periodic_kind::translated);
  for (const boundary_edge& e : whole.boundary) {
    if (e.marker != 2 && e.marker != 4) continue;
    mesh spoiled = whole;
    double& y = spoiled.sites[e.a].position.y;
    y = std::nextafter(y, 2);
    const auto found = match_periodic(spoiled, {4, 2});
    REQUIRE(found);
    CHECK(found.value().kind == periodic_kind::matched);
    CHECK(found.value().greatest_offset > 0);
    CHECK(found.value().greatest_offset <= 0x1p-51);
    y += 0.001;
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
  }
}

TEST_CASE(
    "the auditor refuses lines that are none, and edges that are missing, moved or internal") {
  const mesh whole = periodic_square();
  std::size_t edges = 0;
  for (std::size_t e = 0; e < whole.boundary.size(); ++e) {
    if (whole.boundary[e].marker != 2) continue;
    ++edges;
    mesh spoiled = whole;
    spoiled.boundary[e].marker = 7;
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
    spoiled = whole;
    spoiled.boundary[e].internal = true;
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
    spoiled = whole;
    std::swap(spoiled.boundary[e].a, spoiled.boundary[e].b);
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
    spoiled = whole;
    spoiled.boundary[e].b = static_cast<vertex_index>(whole.sites.size());
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
    spoiled = whole;
    spoiled.sites[spoiled.boundary[e].a].position.x = std::nan("");
    CHECK_FALSE(match_periodic(spoiled, {4, 2}));
  }
  CHECK(edges > 5);
  const auto none = match_periodic(whole, {4, 5});
  REQUIRE_FALSE(none);
  CHECK(none.failure().message.find("markers 4 and 5") != std::string::npos);
  CHECK_FALSE(match_periodic(whole, {2, 2}));
}

TEST_CASE("how far metrics of partners are apart is the ln of the greatest ratio of lengths") {
  mesh m = periodic_square();
  for (site& s : m.sites) s.metric = {4, 1, 3};
  REQUIRE(match_periodic(m, {4, 2}));
  CHECK(match_periodic(m, {4, 2}).value().metrics_apart == 0);
  for (const boundary_edge& e : m.boundary)
    if (e.marker == 2) m.sites[e.b].metric = {4 * 9, 1 * 9, 3 * 9};
  CHECK(std::abs(match_periodic(m, {4, 2}).value().metrics_apart - elementary::log(3)) < 1e-14);
  CHECK(std::abs(match_periodic(m, {2, 4}).value().metrics_apart - elementary::log(3)) < 1e-14);
}
