// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/cracks.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace asterism;

namespace {

bool are_same(const boundary_edge& e, const boundary_edge& f) {
  return e.a == f.a && e.b == f.b && e.marker == f.marker && e.internal == f.internal &&
         e.segment == f.segment;
}

// Two squares of two triangles each. The vertices of their common side are there twice, but for the
// lower end where it is joined.
mesh two_squares(bool with_tip, int left, int right) {
  mesh m;
  for (const point p : {point{0, 0}, point{1, 0}, point{2, 0}, point{2, 1}, point{1, 1},
                        point{0, 1}, point{1, 1}, point{1, 0}})
    m.sites.push_back({p, {1, 0, 1}});
  const vertex_index low = with_tip ? 1 : 7;  // vertices of the right square
  m.triangles = {{0, 1, 4}, {0, 4, 5}, {low, 2, 3}, {low, 3, 6}};
  m.boundary = {{0, 1, 0, 1, false},    {low, 2, 1, 1, false},    {2, 3, 2, 1, false},
                {3, 6, 3, 1, false},    {4, 5, 4, 1, false},      {5, 0, 5, 1, false},
                {1, 4, 6, left, false}, {6, low, 7, right, false}};
  if (with_tip) m.sites.pop_back();
  return m;
}

}  // namespace

TEST_CASE("sides that are there twice are joined, and parted again") {
  for (const bool with_tip : {true, false})
    for (const auto& [left, right] : {std::pair{7, 8}, {8, 7}, {1, 1}, {5, 5}}) {
      INFO(with_tip << ' ' << left << ' ' << right);
      mesh m = two_squares(with_tip, left, right);
      const auto joined = join_cracks(m);
      REQUIRE(joined.ok());
      CHECK(joined.value().joined == (with_tip ? 1 : 2));
      CHECK(m.sites.size() == 6);
      CHECK(m.boundary.size() == 7);
      REQUIRE(joined.value().markers.size() == 1);
      const auto& [number, sides] = *joined.value().markers.begin();
      CHECK(std::minmax(sides.left, sides.right) == std::minmax(left, right));
      CHECK(std::count_if(m.boundary.begin(), m.boundary.end(),
                          [](const boundary_edge& e) { return e.internal; }) == 1);
      // Inside the mesher a crack has a marker that no edge has.
      CHECK((number == left) == (left == right && left != 1));

      const parted_mesh parted = part_cracks(m, joined.value().markers);
      // A tip on the boundary is there twice as well.
      CHECK(parted.content.sites.size() == 8);
      CHECK(parted.original.size() == 8);
      CHECK(parted.content.boundary.size() == 8);
      mesh again = parted.content;
      const auto rejoined = join_cracks(again);
      REQUIRE(rejoined.ok());
      CHECK(again.triangles == m.triangles);
      CHECK(std::equal(again.boundary.begin(), again.boundary.end(), m.boundary.begin(),
                       m.boundary.end(), are_same));
    }
}

TEST_CASE("the vertex of both sides has a metric as fine as both") {
  mesh m = two_squares(true, 1, 1);
  m.sites[4].metric = {4, 0, 1};
  m.sites[6].metric = {1, 0, 9};
  REQUIRE(join_cracks(m).ok());
  CHECK(m.sites[4].metric.m11 == Approx(4));
  CHECK(m.sites[4].metric.m22 == Approx(9));
}

TEST_CASE("triangles with vertices of their own are no mesh with slits alone") {
  mesh joined = two_squares(false, 1, 1), apart;
  for (const triangle& t : joined.triangles) {
    const auto first = static_cast<vertex_index>(apart.sites.size());
    for (const vertex_index v : t) apart.sites.push_back(joined.sites[v]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  const auto refused = join_cracks(apart);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().message.find("join those at one place") != std::string::npos);
}

TEST_CASE("vertices at one place are refused away from slits, and the mesh stays as it is") {
  mesh m;
  for (const point p :
       {point{0, 0}, point{1, 0}, point{0, 1}, point{0, 0}, point{-1, 0}, point{0, -1}})
    m.sites.push_back({p, {1, 0, 1}});
  m.triangles = {{0, 1, 2}, {3, 4, 5}};
  const auto refused = join_cracks(m);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().message.find("vertex 1 and vertex 4 are at the same point") == 0);
  CHECK(m.sites.size() == 6);
  CHECK(m.boundary.empty());

  mesh flat;
  for (const point p : {point{0, 0}, point{1, 0}, point{0, 0}})
    flat.sites.push_back({p, {1, 0, 1}});
  flat.triangles = {{0, 1, 2}};
  const auto other = join_cracks(flat);
  REQUIRE_FALSE(other.ok());
  CHECK(other.failure().message.find("both are corners of triangle 1") != std::string::npos);
}
