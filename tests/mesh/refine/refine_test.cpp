// SPDX-License-Identifier: MIT
//
// Whole complete meshes, certified by the auditor, which shares no code with the mesher.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "asterism/mesh/mesher.hpp"
#include "fixtures/judged_mesh.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

void check_certified(const domain& d, const metric_field& field, const mesh_options& options) {
  const mesh_outcome made = make_and_check(d, field, options);
  CHECK(made.disagreeing == 0);
  CHECK(made.low_angle == 0);
  CHECK(made.too_large == 0);
  CHECK(made.sites == made.result.given + made.inserted + made.splits);
}

mesh_options with_bound(double degrees) {
  mesh_options options;
  options.angle_bound = degrees;
  return options;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const std::vector<site>& a, const std::vector<site>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const site& s, const site& t) {
    return same_bits(s.position.x, t.position.x) && same_bits(s.position.y, t.position.y) &&
           same_bits(s.metric.m11, t.metric.m11) && same_bits(s.metric.m12, t.metric.m12) &&
           same_bits(s.metric.m22, t.metric.m22);
  });
}

}  // namespace

TEST_CASE("square, ten points kept: identity, swirl and sink meet their bounds") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    INFO("seed " << seed);
    const domain d = square_with_points(seed);
    check_certified(d, identity_field(), with_bound(20));
    check_certified(d, swirl_field(3), with_bound(20));
    check_certified(d, sink_field(3), with_bound(15));
  }
  check_certified(square_with_points(1), swirl_field(12), with_bound(5));
  check_certified(square_with_points(2), swirl_field(12), with_bound(10));
  check_certified(square_with_points(3), swirl_field(12), with_bound(15));
  check_certified(square_with_points(1), sink_field(12), with_bound(20));
}

TEST_CASE("swirl:12 at 20 degrees: the corners of 22.6 degrees stay undivided") {
  const domain d = square_with_points(1);
  const mesh_outcome made = mesh_of(d, swirl_field(12), with_bound(20));
  REQUIRE(made.complete);
  CHECK(audited(d, made, with_bound(20)).certified);
  CHECK(made.exempt.empty());
  CHECK(made.sites < 250);
  for (asterism::vertex_index corner = 0; corner < 4; ++corner) {
    const auto here = std::count_if(
        made.result.triangles.begin(), made.result.triangles.end(),
        [&](const triangle& t) { return std::find(t.begin(), t.end(), corner) != t.end(); });
    CHECK(here == 1);
  }
}

TEST_CASE("the swirl's symmetric square, without random points") {
  check_certified(square(), swirl_field(3), with_bound(20));
  check_certified(square(), swirl_field(12), with_bound(10));
}

TEST_CASE("a corner below the bound is exempt, named and certified as such") {
  const domain d = polygon({{0, 0}, {1, 0}, {0.95, 0.2}});  // 11.9 degrees at the first vertex
  const mesh_outcome made = mesh_of(d, identity_field(), with_bound(20));
  CHECK(made.complete);
  REQUIRE(made.exempt.size() == 1);
  CHECK(made.exempt[0].vertex == 0);
  CHECK(made.exempt[0].angle == Approx(std::atan2(0.2, 0.95) * 180 / 3.14159265358979));
  CHECK_FALSE(made.exempt_triangles.empty());
  CHECK(audited(d, made, with_bound(20)).certified);
}

TEST_CASE("a square whose corners are all exempt is refined nevertheless") {
  // At K = 24 the corners have 16.3 degrees. The square without further sites consists of two
  // triangles, both beside exempt ones.
  const mesh_outcome made = mesh_of(square(), swirl_field(24), with_bound(20));
  CHECK(made.complete);
  CHECK(made.triangles > 100);
  CHECK(made.exempt.size() == 4);
  CHECK(made.exempt_triangles.size() <= 4);
}

TEST_CASE("domains that are not convex, and holes") {
  const domain ell = polygon({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}});
  const domain crooked = polygon({{0, 0}, {1, 0.1}, {2, -0.2}, {2.3, 1.1}, {1.2, 0.6}, {0.3, 1.3}});
  const domain slit =
      polygon({{-1, -1}, {1, -1}, {1, 1}, {0.02, 1}, {0, -0.5}, {-0.02, 1}, {-1, 1}});
  for (const domain* d : {&ell, &crooked}) {
    check_certified(*d, identity_field(), with_bound(20));
    check_certified(*d, swirl_field(3), with_bound(15));
  }
  check_certified(slit, identity_field(), with_bound(20));
  check_certified(square_with_hole(), identity_field(), with_bound(25));
  check_certified(square_with_hole(), sink_field(3), with_bound(20));
}

TEST_CASE("a size limit gives edges around metric length 1") {
  mesh_options options = with_bound(20);
  options.limit_size = true;
  const domain d = square();
  const formula_field field = constant_field({25, 0, 25});  // edges of length 0.2
  check_certified(d, field, options);
  const mesh_outcome made = mesh_of(d, field, options);
  double sum = 0;
  std::size_t edges = 0;
  for (const triangle& t : made.result.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const point &a = made.result.sites[t[i]].position,
                  &b = made.result.sites[t[(i + 1) % 3]].position;
      sum += 5 * std::hypot(a.x - b.x, a.y - b.y);
      ++edges;
    }
  const double mean = sum / static_cast<double>(edges);
  CHECK(mean > 0.8);
  CHECK(mean < 1.2);
}

TEST_CASE("Poisson darts reach 10 degrees") {
  mesh_options options = with_bound(10);
  options.strategy = refinement_strategy::poisson_darts;
  for (const std::uint64_t seed : {1u, 2u}) {
    INFO("seed " << seed);
    options.seed = seed;
    check_certified(square_with_points(seed), swirl_field(3), options);
    check_certified(square_with_points(seed), sink_field(3), options);
  }
}

// Neighbours of this star replace each other in turn. That is found only when the star is
// constructed anew at the very end, from its former neighbours.
TEST_CASE("a star that does not settle at the end is mended, not passed over") {
  domain d = square();
  d.vertices.insert(d.vertices.end(), {{-0.8400401032127593, 0.4218608754161983},
                                       {-0.6642490113382689, 0.6151950681860909},
                                       {0.64133644387605, 0.8081181316317065},
                                       {0.5172772156672469, 0.5123309420812894},
                                       {0.8517706879488287, -0.3722699924757167},
                                       {-0.46610158314692773, -0.38047268176908133},
                                       {-0.8972265139555557, 0.7193210208384104},
                                       {-0.8249323843996075, -0.37319869066361555},
                                       {-0.4987431452121394, 0.7545644234069422},
                                       {-0.6621015063304818, -0.369857463631071}});
  mesh_options options = with_bound(5);
  options.strategy = refinement_strategy::poisson_darts;
  options.seed = 10;
  check_certified(d, sink_field(12), options);
}

TEST_CASE("an impossible bound ends within the limit and says so") {
  mesh_options options = with_bound(59);
  options.max_sites = 300;
  const domain d = square_with_points(4);
  for (const auto strategy :
       {refinement_strategy::voronoi_arcs, refinement_strategy::poisson_darts}) {
    options.strategy = strategy;
    const mesh_outcome made = mesh_of(d, identity_field(), options);
    CHECK_FALSE(made.complete);
    CHECK_FALSE(ending_text(made).empty());
    CHECK(made.sites <= 300);
    CHECK(made.low_angle + made.disagreeing > 0);
    // The certain triangles are kept, and fit: no directed edge is there twice.
    std::vector<std::pair<asterism::vertex_index, asterism::vertex_index>> edges;
    for (const triangle& t : made.result.triangles)
      for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  }
}

TEST_CASE("a tolerance that was given is kept: stuck is said, not worked around") {
  mesh_options options = with_bound(20);
  options.tolerance = 0.9;
  const mesh_outcome made = mesh_of(square_with_points(1), swirl_field(12), options);
  CHECK_FALSE(made.complete);
  CHECK(made.ended.tolerance == 0.9);
  CHECK(made.how() == ending::stuck);
  CHECK(ending_text(made).find("0.9") != std::string::npos);
}

TEST_CASE("two runs are the same, bit for bit") {
  for (const auto strategy :
       {refinement_strategy::voronoi_arcs, refinement_strategy::poisson_darts}) {
    mesh_options options = with_bound(10);
    options.strategy = strategy;
    const domain d = square_with_points(5);
    const mesh_outcome a = mesh_of(d, swirl_field(3), options);
    const mesh_outcome b = mesh_of(d, swirl_field(3), options);
    CHECK(same_bits(a.result.sites, b.result.sites));
    CHECK(a.result.triangles == b.result.triangles);
    CHECK(a.candidates_rejected == b.candidates_rejected);
  }
}

TEST_CASE("scaling by a power of two scales the mesh, bit for bit") {
  const domain d = square_with_points(2);
  const mesh_outcome made = mesh_of(d, swirl_field(3), with_bound(20));
  for (const int power : {-400, 400}) {
    domain scaled = d;
    for (point& q : scaled.vertices) q = {std::ldexp(q.x, power), std::ldexp(q.y, power)};
    const formula_field field([power](const point& q) {
      return swirl_field(3).at({std::ldexp(q.x, -power), std::ldexp(q.y, -power)}).value();
    });
    const mesh_outcome far = mesh_of(scaled, field, with_bound(20));
    CHECK(far.complete);
    CHECK(far.result.triangles == made.result.triangles);
    REQUIRE(far.sites == made.sites);
    for (std::size_t i = 0; i < far.sites; ++i)
      CHECK(far.result.sites[i].position.x == std::ldexp(made.result.sites[i].position.x, power));
  }
}

TEST_CASE("the given vertices come first, unchanged; markers and segments are carried") {
  domain d = square_with_points(6);
  for (std::size_t i = 0; i < 4; ++i) d.segments[i].marker = static_cast<int>(10 + i);
  const mesh_outcome made = mesh_of(d, swirl_field(3), with_bound(20));
  REQUIRE(made.result.given == d.vertices.size());
  for (std::size_t i = 0; i < d.vertices.size(); ++i)
    CHECK(made.result.sites[i].position == d.vertices[i]);
  for (const boundary_edge& e : made.result.boundary)
    CHECK(e.marker == static_cast<int>(10 + e.segment));
}

TEST_CASE("options out of range are refused, and so is a field that fails") {
  const domain d = square();
  const formula_field field = identity_field();
  const auto refused = [&](const mesh_options& options) {
    const auto made = make_mesh(d, field, options);
    return !made.ok() && made.failure().code == error_code::bad_option &&
           !made.failure().message.empty();
  };
  mesh_options options;
  for (const double bound : {-1.0, 60.0, std::nan("")}) CHECK(refused(with_bound(bound)));
  for (const double tolerance : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.tolerance = tolerance;
    CHECK(refused(options));
  }
  options = {};
  options.max_sites = 3;
  CHECK(refused(options));
  options = {};
  options.max_rejected = 0;
  CHECK(refused(options));

  class failing final : public metric_field {
    result<metric_tensor> at(const point& q) const override {
      if (std::abs(q.x) < 0.9) return error{"no metric here"};
      return metric_tensor{100, 0, 100};
    }
  };
  options = {};
  options.limit_size = true;
  const auto made = make_mesh(d, failing(), options);
  REQUIRE_FALSE(made.ok());
  CHECK(made.failure().message == "no metric here");
}

TEST_CASE("progress is reported and its last word is the outcome's") {
  mesh_progress last;
  std::size_t calls = 0;
  const auto made =
      make_mesh(square_with_points(1), swirl_field(3), with_bound(20), [&](const mesh_progress& p) {
        last = p;
        ++calls;
      });
  REQUIRE(made.ok());
  CHECK(calls > 1);
  CHECK(last.sites == made.value().sites);
  CHECK(last.disagreeing == 0);
}
