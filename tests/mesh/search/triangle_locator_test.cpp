// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/triangle_locator.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// n x n cells of two triangles, sheared, in the unit square, and one triangle without area.
mesh sheared_grid(vertex_index n) {
  mesh m;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i)
      m.sites.push_back({{(i + 0.3 * j) / n, double(j) / n}, {1, 0, 1}});
  const auto at = [n](vertex_index i, vertex_index j) { return i + j * (n + 1); };
  m.triangles.push_back({at(0, 0), at(1, 0), at(2, 0)});
  for (vertex_index j = 0; j < n; ++j)
    for (vertex_index i = 0; i < n; ++i) {
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      m.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return m;
}

point at_weights(const triangle_locator& locator, const triangle_locator::located& where) {
  point q{0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const point& corner = locator.places()[locator.triangles()[where.triangle][i]];
    q.x += where.weights[i] * corner.x;
    q.y += where.weights[i] * corner.y;
  }
  return q;
}

}  // namespace

TEST_CASE("a point inside is at the weights that are found, from any hint") {
  const std::uint64_t seed = 91;
  CAPTURE(seed);
  splitmix64 random(seed);
  const mesh m = sheared_grid(7);
  const triangle_locator locator(m);
  REQUIRE(locator.triangles().size() == m.triangles.size() - 1);  // without the one of no area
  for (int i = 0; i < 2000; ++i) {
    const double y = random.real(0.001, 0.999), x = 0.3 * y + random.real(0.001, 0.999);
    CAPTURE(x, y);
    const auto deepest = locator.deepest({x, y});
    for (const vertex_index hint : {deepest.triangle, vertex_index(random.bits() % 98), ~0U}) {
      const auto found = locator.nearby({x, y}, hint);
      CHECK(at_weights(locator, found).x == Approx(x).margin(1e-12));
      CHECK(at_weights(locator, found).y == Approx(y).margin(1e-12));
      CHECK(found.looked_at == 0);  // the walk ends in a triangle
    }
    CHECK(at_weights(locator, deepest).x == Approx(x).margin(1e-12));
    CHECK(deepest.looked_at > 0);
  }
}

TEST_CASE("a point outside gets a triangle near it and no negative weight") {
  const mesh m = sheared_grid(4);
  const triangle_locator locator(m);
  for (const point& q : {point{-0.1, 0.05}, point{0.5, -2}, point{40, 0.9}, point{-1e6, -1e6}}) {
    CAPTURE(q.x, q.y);
    const auto deepest = locator.deepest(q), walked = locator.nearby(q, 3);
    CHECK(*std::min_element(deepest.weights.begin(), deepest.weights.end()) >= 0);
    CHECK(walked.triangle == deepest.triangle);
    CHECK(walked.weights == deepest.weights);
  }
}

TEST_CASE("of triangles that share an edge the first one has its points") {
  const mesh m = sheared_grid(2);
  const triangle_locator locator(m);
  const point &a = locator.places()[1], &b = locator.places()[4];
  const point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const auto found = locator.deepest(middle);
  for (vertex_index t = 0; t < found.triangle; ++t) {
    const triangle& c = locator.triangles()[t];
    CHECK_FALSE((std::count(c.begin(), c.end(), 1) == 1 && std::count(c.begin(), c.end(), 4) == 1));
  }
}

TEST_CASE("a search from triangles found before ends where the search of all boxes does") {
  const std::uint64_t seed = 92;
  CAPTURE(seed);
  splitmix64 random(seed);
  mesh m = sheared_grid(9);
  m.triangles.erase(m.triangles.begin() + 80, m.triangles.begin() + 83);  // walks meet a hole
  const triangle_locator locator(m);
  const auto check = [&locator](const point& q) {
    CAPTURE(q.x, q.y);
    const auto& places = locator.places();
    if (std::find(places.begin(), places.end(), q) != places.end()) return;
    const auto deepest = locator.deepest(q), found = locator.find(q);
    CHECK(found.triangle == deepest.triangle);
    CHECK(found.weights == deepest.weights);
    CHECK(found.reach == deepest.reach);
  };
  for (int i = 0; i < 1000; ++i) {
    if (i % 3 == 0) locator.begin_near({0.5, 0.5}, static_cast<vertex_index>(random.bits() % 200));
    check({random.real(-0.1, 1.4), random.real(-0.1, 1.1)});
    const auto& places = locator.places();
    const point &a = places[random.bits() % places.size()], &b = places[random.bits() % 10];
    const double part = random.real(0, 1);
    check({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});  // often on edges
    check({a.x * (1 + 1e-15), a.y});                              // next to a place
  }
  for (const triangle& t : locator.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      const point &a = locator.places()[t[i]], &b = locator.places()[t[(i + 1) % 3]];
      check({(a.x + b.x) / 2, (a.y + b.y) / 2});
    }
}

TEST_CASE("at a place the search finds a triangle there") {
  const triangle_locator locator(sheared_grid(6));
  for (vertex_index v = 0; v < locator.places().size(); ++v) {
    const triangle& t = locator.triangles()[locator.find(locator.places()[v]).triangle];
    CHECK(std::count(t.begin(), t.end(), v) == 1);
  }
}

TEST_CASE("each edge is listed once") {
  const triangle_locator locator(sheared_grid(5));
  std::vector<std::pair<vertex_index, vertex_index>> edges;
  for (const graph_edge& e : locator.edges()) edges.push_back(std::minmax(e.a, e.b));
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  CHECK(edges.size() == 5 * 6 + 5 * 6 + 5 * 5);
}
