// SPDX-License-Identifier: MIT
//
// Repairs random invalid domains, at every scale and far from the origin: check_domain then accepts
// them without repairs of its own.
#include "asterism/mesh/domain/repair_domain.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/exact_lengths.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

struct drawing {
  domain d;
  internal::splitmix64 random{7};

  double uniform() { return static_cast<double>(random.bits() >> 11) * 0x1p-53; }
  void ring(const std::vector<point>& corners) {
    const auto first = static_cast<vertex_index>(d.vertices.size());
    const auto n = static_cast<vertex_index>(corners.size());
    d.vertices.insert(d.vertices.end(), corners.begin(), corners.end());
    for (vertex_index i = 0; i < n; ++i)
      d.segments.push_back({first + i, first + (i + 1) % n, static_cast<int>(i) + 1});
  }
  void segment_between(const point& p, const point& q) {
    const auto first = static_cast<vertex_index>(d.vertices.size());
    d.vertices.insert(d.vertices.end(), {p, q});
    d.segments.push_back({first, first + 1, 0});
  }
};

// Segments that all cross each other.
domain crossing_segments(std::size_t n) {
  drawing made;
  made.ring({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}});
  for (std::size_t i = 0; i < n; ++i)
    made.segment_between({made.uniform(), made.uniform()}, {made.uniform(), made.uniform()});
  return made.d;
}

domain ring_across_itself(std::size_t n) {
  drawing made;
  std::vector<point> corners;
  for (std::size_t i = 0; i < n; ++i) corners.push_back({made.uniform(), made.uniform()});
  made.ring(corners);
  return made.d;
}

// Exact overlaps of all kinds.
domain overlapping_lines() {
  drawing made;
  made.ring({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  const auto place = [&] { return static_cast<double>(made.random.bits() % 21); };
  for (int i = 0; i < 400; ++i) {
    const double x = place(), a = place(), b = place();
    if (i % 2 == 0)
      made.segment_between({x, a}, {x, b});
    else
      made.segment_between({a, x}, {b, x});
  }
  return made.d;
}

// Nine places, each hit to within some last places.
domain near_points() {
  drawing made;
  made.ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const auto place = [&] {
    const double grid[] = {0.1, 0.3, 0.7};
    return grid[made.random.bits() % 3] +
           (static_cast<double>(made.random.bits() % 7) - 3) * 0x1p-53;
  };
  for (int i = 0; i < 200; ++i) {
    const double x = place(), y = place(), u = place(), w = place();
    made.segment_between({x, y}, {u, w});
  }
  return made.d;
}

domain moved(domain d, double scale, double offset) {
  const auto move = [&](point& p) { p = {p.x * scale + offset, p.y * scale + offset}; };
  for (point& p : d.vertices) move(p);
  for (point& p : d.holes) move(p);
  return d;
}

domain repaired(const domain& d, domain_repairs& repairs) {
  const auto made = repair_domain(d, {}, &repairs);
  INFO((made.ok() ? "" : made.failure().message));
  REQUIRE(made.ok());
  return made.value();
}

}  // namespace

TEST_CASE("hostile domains are repaired at every scale, and need no other repair") {
  const std::pair<std::string, domain> hostile[] = {{"crossing", crossing_segments(60)},
                                                    {"ring", ring_across_itself(50)},
                                                    {"overlaps", overlapping_lines()},
                                                    {"near", near_points()}};
  for (const auto& [name, d] : hostile)
    for (const auto& [scale, offset] :
         {std::pair{1.0, 0.0}, {1.0, 1e8}, {0x1p-400, 0.0}, {0x1p400, 0.0}, {1e-3, -5e11}}) {
      INFO(name << " times " << scale << " plus " << offset);
      domain_repairs repairs, second;
      const domain clean = repaired(moved(d, scale, offset), repairs);
      CHECK(repairs.any());
      CHECK(repairs.places.size() > 0);
      // Vertices move by rounding or by joining, so by no more than twice the distance.
      CHECK(repairs.greatest_move <= 2 * repairs.distance);
      REQUIRE(check_domain(clean, &second).ok());
      CHECK_FALSE(second.any());
    }
}

TEST_CASE("two hundred random segments fall into thousands of pieces") {
  domain_repairs repairs;
  const domain clean = repaired(crossing_segments(200), repairs);
  CHECK(repairs.crossings > 4000);
  CHECK(clean.vertices.size() > repairs.crossings);
}

TEST_CASE("a repair ends with the work that it is given, at the same place each time") {
  const domain d = crossing_segments(400);
  std::string said;
  for (int time = 0; time < 2; ++time) {
    const cancellation bounded = cancellation().with_work(500);
    const auto refused = repair_domain(d, {}, nullptr, bounded);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.failure().message.find("the repair was ended: the most work") !=
          std::string::npos);
    CHECK(bounded.units_left() <= 0);
    CHECK(bounded.units_left() > -500);
    CHECK((time == 0 || said == refused.failure().message));
    said = refused.failure().message;
  }
  const cancellation ample = cancellation().with_work(1e6);
  CHECK(repair_domain(d, {}, nullptr, ample).ok());
  CHECK(ample.units_left() < 1e6);
}

TEST_CASE("after a repair points are apart, and segments pass none of them") {
  domain_repairs repairs;
  const domain clean = repaired(near_points(), repairs);
  for (std::size_t v = 0; v < clean.vertices.size(); ++v) {
    for (std::size_t w = 0; w < v; ++w)
      CHECK_FALSE(are_nearer(clean.vertices[v], clean.vertices[w], repairs.distance));
    for (const segment& s : clean.segments)
      if (s.a != v && s.b != v)
        CHECK_FALSE(is_beside(clean.vertices[v], clean.vertices[s.a], clean.vertices[s.b],
                              repairs.distance / 2));
  }
}

TEST_CASE("points of the input keep their coordinates, and markers go with the pieces") {
  drawing made;
  made.ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  made.d.vertices.insert(made.d.vertices.end(), {{0.1, 0.2}, {0.7, 0.9}, {0.2, 0.8}, {0.8, 0.3}});
  made.d.segments.push_back({4, 5, 7});
  made.d.segments.push_back({6, 7, 8});
  domain_repairs repairs;
  const domain clean = repaired(made.d, repairs);
  CHECK(repairs.crossings == 1);
  CHECK(repairs.joined_vertices + repairs.bent_segments + repairs.trimmed_segments == 0);
  REQUIRE(clean.vertices.size() == 9);
  for (std::size_t v = 0; v < 8; ++v) CHECK(clean.vertices[v] == made.d.vertices[v]);
  std::size_t sevens = 0, eights = 0;
  for (const segment& s : clean.segments) {
    sevens += s.marker == 7 ? 1 : 0;
    eights += s.marker == 8 ? 1 : 0;
  }
  CHECK(sevens == 2);
  CHECK(eights == 2);
}

TEST_CASE("a gap is closed by the least distance that closes it") {
  drawing made;
  made.ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  made.d.vertices.push_back({1e-9, 1e-9});
  made.d.segments[0].a = 4;
  domain_repairs repairs;
  const domain clean = repaired(made.d, repairs);
  CHECK(clean.vertices.size() == 4);
  CHECK(repairs.distance == 0x1p-28);
  CHECK(repairs.joined_vertices == 1);
  // A distance that is given is used unchanged.
  CHECK_FALSE(repair_domain(made.d, 1e-10).ok());
  CHECK(repair_domain(made.d, 1e-8).ok());
}

TEST_CASE("what cannot be repaired is refused as ever") {
  drawing wide;
  wide.ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  wide.d.vertices.push_back({0.1, 0.1});
  wide.d.segments[0].a = 4;
  const auto open = repair_domain(wide.d);
  REQUIRE_FALSE(open.ok());
  CHECK(open.failure().message.find("not closed") != std::string::npos);
  CHECK(open.failure().message.find("after repairs up to a distance of 0.000244") !=
        std::string::npos);
  drawing bad;
  bad.ring({{0, 0}, {std::numeric_limits<double>::infinity(), 0}, {1, 1}});
  CHECK_FALSE(repair_domain(bad.d).ok());
  drawing huge;
  huge.ring({{-1e308, -1e308}, {1e308, -1e308}, {1e308, 1e308}});
  CHECK_FALSE(repair_domain(huge.d).ok());
  for (const double distance : {0.0, -1.0, 1e200, std::nan("")})
    CHECK_FALSE(repair_domain(crossing_segments(2), distance).ok());
}

TEST_CASE("a hole as thin as the distance is dropped with its point") {
  drawing made;
  made.ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  made.ring({{0.25, 0.5}, {0.75, 0.5}, {0.75, 0.5 + 0x1p-50}, {0.25, 0.5 + 0x1p-50}});
  made.d.holes.push_back({0.5, 0.5 + 0x1p-51});
  domain_repairs repairs;
  const domain clean = repaired(made.d, repairs);
  CHECK(repairs.dropped_holes == 1);
  CHECK(clean.holes.empty());
  CHECK(clean.vertices.size() == 6);
}
