// SPDX-License-Identifier: MIT
//
// Domains of every kind there is, small, as check_domain accepts them.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/domain_check.hpp"
#include "star_fixture.hpp"

namespace asterism::testing {

inline domain accepted(const domain& d) {
  auto checked = check_domain(d);
  INFO((checked.ok() ? "" : checked.failure().message));
  REQUIRE(checked.ok());
  return std::move(checked).value();
}

// Vertices of its own, and segments through them.
inline void add_chain(domain& d, const std::vector<point>& chain, int marker = 5) {
  const auto start = static_cast<index>(d.vertices.size());
  d.vertices.insert(d.vertices.end(), chain.begin(), chain.end());
  for (index i = 0; i + 1 < chain.size(); ++i)
    d.segments.push_back({start + i, start + i + 1, marker});
}

inline std::vector<point> box_ring(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline domain with_diagonal() {
  domain d = square();
  d.segments.push_back({0, 2, 5});
  return accepted(d);
}

// A segment from the middle of a side inwards, and one that touches nothing.
inline domain with_dangling_segments() {
  domain d = square();
  add_chain(d, {{0, -1}, {0.125, 0.25}});
  add_chain(d, {{-0.5, 0.5}, {-0.25, 0.75}, {0.5, 0.625}});
  return accepted(d);
}

inline domain with_isolated_point() {
  domain d = square();
  d.vertices.push_back({0.3, 0.2});
  return accepted(d);
}

inline domain two_components() {
  domain d = square();
  add_ring(d, {{2, 0}, {3, 0}, {3, 1}});
  return accepted(d);
}

inline domain island_in_hole() {
  domain d = polygon(box_ring(0, 0, 8, 8));
  add_ring(d, box_ring(1, 1, 7, 7));
  add_ring(d, box_ring(3, 3, 5, 5));
  d.holes = {{2, 2}};
  return accepted(d);
}

// Two squares with a common corner, a hole that touches a side from inside, and two holes with a
// common side.
inline domain touching_rings() {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_ring(d, box_ring(4, 4, 6, 6));
  add_ring(d, {{0, 2}, {1, 1}, {1.5, 2}, {1, 3}});
  add_ring(d, box_ring(2.5, 1, 3, 2));
  add_ring(d, box_ring(3, 1, 3.5, 2));
  d.holes = {{0.75, 2}, {2.75, 1.5}, {3.25, 1.5}};
  return accepted(d);
}

// Segments that meet in one inner vertex in angles down to some 8 degrees.
inline domain with_fan() {
  domain d = square();
  d.vertices.push_back({0, 0});
  for (const point& end : {point{0.75, 0}, {0.75, 0.1}, {0.6, 0.7}, {-0.7, 0.3}, {-0.7, 0.2}}) {
    d.vertices.push_back(end);
    d.segments.push_back({4, static_cast<index>(d.vertices.size() - 1), 5});
  }
  return accepted(d);
}

// A ring inside that is no hole, a segment across it, and a segment along both: three regions.
inline domain divided() {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_ring(d, box_ring(1, 1, 3, 3));
  add_chain(d, {{0.5, 2}, {3.5, 2}});
  d.vertices.push_back({1, 2});
  d.vertices.push_back({3, 2});
  d.regions = {{{2, 1.5}, 7}, {{2, 2.5}, -3}};
  return accepted(d);
}

struct named_domain {
  std::string name;
  domain shape;
};

inline std::vector<named_domain> domain_kinds() {
  return {{"diagonal", with_diagonal()},
          {"dangling segments", with_dangling_segments()},
          {"isolated point", with_isolated_point()},
          {"two components", two_components()},
          {"island in hole", island_in_hole()},
          {"touching rings", touching_rings()},
          {"fan", with_fan()},
          {"divided", divided()}};
}

}  // namespace asterism::testing
