// SPDX-License-Identifier: MIT
//
// Random planar straight-line graphs on a small grid, with repeated points, overlapping segments,
// dangling chains, and holes and region points anywhere. Each is refused, or meshed and certified.
// Regions and points of the mesh are compared with a second computation.
#include <catch2/catch.hpp>
#include <map>

#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/stars/visibility.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;
using asterism::vertex_index;

namespace {

struct random_graph {
  explicit random_graph(std::uint64_t seed) : random(seed) {
    if (seed % 3 != 0) add_ring(d, box_ring(0, 0, grid, grid));
    const std::size_t rings = random.bits() % 3, segments = random.bits() % 8;
    for (std::size_t i = 0; i < rings; ++i) add_box();
    for (std::size_t i = 0; i < segments; ++i) add_segment(any_vertex(), any_vertex());
    for (std::size_t i = random.bits() % 3; i > 0; --i) d.vertices.push_back(grid_point());
    for (std::size_t i = random.bits() % 2; i > 0; --i) d.holes.push_back(loose_point());
    for (std::size_t i = random.bits() % 3; i > 0; --i)
      d.regions.push_back({loose_point(), static_cast<int>(random.bits() % 3)});
    d.number_all_regions = random.bits() % 2 == 0;
  }

  point grid_point() {
    return {static_cast<double>(random.bits() % (grid + 1)),
            static_cast<double>(random.bits() % (grid + 1))};
  }
  // Returns a point on no line through two points of the grid: these have small fractions as slopes
  // and offsets.
  point loose_point() {
    const point q = grid_point();
    return {q.x + 0.375 + 0x1p-20, q.y + 0.28125 - 0x1p-21};
  }
  vertex_index any_vertex() {
    d.vertices.push_back(grid_point());
    return static_cast<vertex_index>(d.vertices.size() - 1);
  }
  void add_segment(vertex_index a, vertex_index b) {
    for (const segment& s : d.segments)
      if (properly_cross(kernel, d.vertices[a], d.vertices[b], d.vertices[s.a], d.vertices[s.b]))
        return;
    d.segments.push_back({a, b, static_cast<int>(random.bits() % 3)});
  }
  void add_box() {
    const point p = grid_point(), q = grid_point();
    const auto start = static_cast<vertex_index>(d.vertices.size());
    for (const point& corner : {p, point{q.x, p.y}, q, point{p.x, q.y}})
      d.vertices.push_back(corner);
    for (vertex_index i = 0; i < 4; ++i) add_segment(start + i, start + (i + 1) % 4);
  }

  static constexpr int grid = 5;
  test::splitmix64 random;
  tier_counters decided;
  star_predicates_on<filtered_kernel> kernel{decided};
  domain d;
};

bool in_triangle(const mesh& m, const triangle& t, const point& q) {
  const filtered_kernel kernel;
  for (std::size_t i = 0; i < 3; ++i)
    if (kernel.orientation(m.sites[t[i]].position, m.sites[t[(i + 1) % 3]].position, q) ==
        sign::negative)
      return false;
  return true;
}

// Returns the region of the triangle that contains the point, none if there is no triangle.
std::optional<int> region_at(const mesh& m, const point& q) {
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    if (in_triangle(m, m.triangles[t], q)) return m.regions.empty() ? 1 : m.regions[t];
  return std::nullopt;
}

// Checks that region points are in their regions, that holes are in no triangle, and that the mesh
// covers the same points of a grid as the domain.
void check_points(const domain& input, const domain& d, const mesh& m) {
  for (const region_point& r : input.regions) CHECK(region_at(m, r.at) == r.number);
  for (const point& hole : input.holes) CHECK_FALSE(region_at(m, hole).has_value());
  for (double x = 0.40625; x < 6; ++x)
    for (double y = 0.3125; y < 6; ++y)
      CHECK(contains(d, {x + 0x1p-21, y}) == region_at(m, {x + 0x1p-21, y}).has_value());
}

enum class fate { refused, stuck, certified };

fate fate_of(const domain& input) {
  const auto checked = check_domain(input);
  if (!checked.ok()) {
    CHECK_FALSE(checked.failure().message.empty());
    return fate::refused;
  }
  const domain& d = checked.value();
  domain_repairs again;
  const auto twice = check_domain(d, &again);
  REQUIRE(twice.ok());
  CHECK_FALSE(again.any());
  mesh_options options;
  options.angle_bound = 15;
  options.max_sites = 2000;
  const mesh_outcome made = testing::mesh_of(d, identity_field(), options);
  if (!made.complete) {
    CHECK_FALSE(ending_text(made).empty());
    return fate::stuck;
  }
  testing::check_audit(d, made, options);
  check_points(input, d, made.result);
  return fate::certified;
}

}  // namespace

TEST_CASE("random graphs on a grid are refused or meshed, and the mesh is certified") {
  std::map<fate, int> count;
  constexpr std::uint64_t seeds = 3000;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    INFO("replay: random_graph(" << seed << ")");
    ++count[fate_of(random_graph(seed).d)];
  }
  CHECK(count[fate::stuck] == 0);
  CHECK(4 * count[fate::certified] > count[fate::refused]);
}
