// SPDX-License-Identifier: MIT
//
// Compares proved distances of two boundaries, in both directions, with sampled ones. Passes over
// boundaries that are not the mesh's.
#include "asterism/mesh/audit/boundary_distance.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "asterism/mesh/audit/certificate.hpp"

using namespace asterism;

namespace {

// A chain of vertices of the mesh from (0, 0) to (1, 0), the only segment of its domain.
struct chain {
  mesh m;
  domain d;

  explicit chain(const std::vector<point>& between) {
    d.vertices = {{0, 0}, {1, 0}};
    d.segments = {{0, 1, 0}};
    for (const point& p : d.vertices) m.sites.push_back({p, {1, 0, 1}});
    m.given = 2;
    vertex_index last = 0;
    for (const point& p : between) {
      const auto v = static_cast<vertex_index>(m.sites.size());
      m.sites.push_back({p, {1, 0, 1}});
      m.boundary.push_back({last, v, 0, 0});
      last = v;
    }
    m.boundary.push_back({last, 1, 0, 0});
  }

  double distance(const std::vector<point>& former) const {
    return measure_former_boundary(m, d, {{former}, {}}).largest_distance;
  }
};

double distance(const point& p, const point& a, const point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double s = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
  return std::hypot(a.x + s * x - p.x, a.y + s * y - p.y);
}

// Returns the greatest distance of points sampled on one polygon from the other one.
double sampled(const std::vector<point>& one, const std::vector<point>& other) {
  constexpr int samples = 50;
  double most = 0;
  for (std::size_t i = 0; i + 1 < one.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      const point p{one[i].x + t * (one[i + 1].x - one[i].x),
                    one[i].y + t * (one[i + 1].y - one[i].y)};
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j + 1 < other.size(); ++j)
        least = std::min(least, distance(p, other[j], other[j + 1]));
      most = std::max(most, least);
    }
  return most;
}

std::vector<point> with_ends(std::vector<point> between) {
  between.insert(between.begin(), {0, 0});
  between.push_back({1, 0});
  return between;
}

}  // namespace

TEST_CASE("a boundary that is the former one is not away from it") {
  CHECK(chain({}).distance({}) == 0);
  CHECK(chain({{0.5, 0.25}}).distance({{0.5, 0.25}}) == 0);
  CHECK(chain({{0.25, 0}, {0.5, 0}}).distance({}) == 0);
  // A third is no double: on one of the two chains the place at equal share is a rounding behind.
  CHECK(chain({{0.25, 0}, {0.5, 0}}).distance({{0.75, 0}}) <= 0x1p-53);
}

TEST_CASE("a vertex that went, and one that came, are as far as they are") {
  CHECK(chain({}).distance({{0.5, 0.125}}) == 0.125);
  CHECK(chain({{0.5, 0.125}}).distance({}) == 0.125);
  CHECK(chain({{0.5, 0.125}}).distance({{0.5, -0.125}}) == 0.25);
}

TEST_CASE("the distance bounds what is sampled, and closely where the polygons are flat") {
  std::uint64_t state = 11;
  const auto next = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  for (int round = 0; round < 200; ++round) {
    const double height = round < 100 ? 0.02 : 2;  // from 100 on, chains also go back along x
    std::vector<std::vector<point>> both(2);
    for (std::vector<point>& one : both) {
      const int count = static_cast<int>(8 * next());
      for (int k = 1; k <= count; ++k)
        one.push_back(
            {(k + (round < 100 ? 0 : 3 * next())) / (count + 1), height * (next() - 0.5)});
    }
    const double bound = chain(both[0]).distance(both[1]);
    const auto now = with_ends(both[0]), before = with_ends(both[1]);
    const double least = std::max(sampled(now, before), sampled(before, now));
    INFO(round);
    CHECK(bound >= least * (1 - 1e-12));
    if (round < 100) CHECK(bound <= 1.1 * least + 1e-12);
  }
}

TEST_CASE("the chords of a curve that is divided are one way") {
  // Two chords of a cubic, from (0, 0) by (0.5, 0.25) to (1, 0). The second is listed last.
  for (const bool is_reversed : {false, true}) {
    domain d;
    d.vertices = {{0, 0}, {1, 0}, {0.5, 0.25}};
    d.segments = {{0, 2, 0}, {2, 1, 0}};
    domain_curve cubic;
    cubic.kind = curve_kind::cubic;
    cubic.control = {{{0.25, 0.3}, {0.75, 0.3}}};
    cubic.vertices = {0, 2, 1};
    cubic.parameters = {0, 0.5, 1};
    d.curves = {cubic};
    mesh m;
    for (const point& p : d.vertices) m.sites.push_back({p, {1, 0, 1}});
    m.given = 3;
    m.boundary = {{0, 2, 0, 0}, {2, 1, 1, 0}};
    if (is_reversed) {
      for (segment& s : d.segments) std::swap(s.a, s.b);
      for (boundary_edge& e : m.boundary) std::swap(e.a, e.b);
    }
    const auto distance = [&](const std::vector<std::vector<point>>& between) {
      return measure_former_boundary(m, d, {between, {}}).largest_distance;
    };
    CHECK(distance({{}, {}}) == 0.25);
    CHECK(distance({{{0.5, 0.25}}, {}}) == 0);
    CHECK(distance({{{0.5, 0.5}}, {}}) == 0.25);
    CHECK(distance({{}, {{0.5, 0.25}}}) == std::numeric_limits<double>::infinity());
    // The chain's points follow the direction of the segments.
    std::vector<point> along = {{0.2, 0.1}, {0.8, 0.1}};
    if (is_reversed) std::reverse(along.begin(), along.end());
    CHECK(distance({along, {}}) < 0.2);
    std::reverse(along.begin(), along.end());
    CHECK(distance({along, {}}) > 0.4);
    // A curve that lacks a chord joins no segments: each segment is judged alone.
    d.curves[0].vertices = {0, 1, 2};
    CHECK(distance({{}, {}}) == 0);
    d.curves[0].vertices = {0, 77, 1};
    CHECK(distance({{}, {}}) == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("what is no boundary of the domain is infinitely far") {
  const double infinity = std::numeric_limits<double>::infinity();
  const chain one({{0.5, 0.125}});
  const auto measured = [](const mesh& m, const domain& d, const former_boundary& f) {
    return measure_former_boundary(m, d, f).largest_distance;
  };
  CHECK(measured(one.m, one.d, {{}, {}}) == infinity);  // there must be a list for each segment
  mesh damaged = one.m;
  damaged.boundary.pop_back();
  CHECK(measured(damaged, one.d, {{{}}, {}}) == infinity);
  damaged = one.m;
  damaged.boundary[1] = {2, 2, 0, 0};
  CHECK(measured(damaged, one.d, {{{}}, {}}) == infinity);
  damaged = one.m;
  damaged.boundary[1] = {2, 99, 0, 0};
  CHECK(measured(damaged, one.d, {{{}}, {}}) == infinity);
  damaged = one.m;
  damaged.sites[0].position.x = 0.001;
  CHECK(measured(damaged, one.d, {{{}}, {}}) == infinity);
  domain other = one.d;
  other.segments[0].b = 77;
  CHECK(measured(one.m, other, {{{}}, {}}) == infinity);
  CHECK(one.distance({{std::nan(""), 0}}) == infinity);
  CHECK(one.distance({{0.5, infinity}}) == infinity);
}
