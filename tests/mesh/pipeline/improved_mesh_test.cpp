// SPDX-License-Identifier: MIT
//
// Improves finished meshes by passes. Accepted meshes are certified and never worse; passes leave
// barred sites and incomplete meshes unchanged.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

mesh_options with_passes(std::size_t passes, bool limit_size) {
  mesh_options options;
  options.improve_passes = passes;
  options.limit_size = limit_size;
  return options;
}

double worst_angle(const mesh_outcome& made) {
  const std::set<triangle> exempt(made.exempt_triangles.begin(), made.exempt_triangles.end());
  double worst = 180;
  for (const triangle& t : made.result.triangles)
    if (exempt.count(t) == 0)
      worst = std::min(worst, smallest_angle({made.result.sites[t[0]], made.result.sites[t[1]],
                                              made.result.sites[t[2]]}));
  return worst;
}

void check_not_worse(const mesh_outcome& before, const mesh_outcome& after) {
  CHECK(after.complete);
  CHECK(after.sites <= before.sites);
  CHECK(worst_angle(after) >= worst_angle(before));
  CHECK(measure(after.result).mean_quality >= measure(before.result).mean_quality);
  CHECK(after.exempt_triangles.size() <= before.exempt_triangles.size());
  REQUIRE(after.improved);
  CHECK(after.improved->sites_before == before.sites);
  CHECK(after.improved->tries <= 10 * (after.improved->passes + 1));
}

formula_field stretched_to_the_sides() {
  return formula_field([](const point& q) {
    return metric_tensor{1 + q.x * q.x / 4, q.x * q.y / 8, 1 + q.y * q.y / 4};
  });
}

bool same(const mesh& a, const mesh& b) { return a.sites == b.sites && a.triangles == b.triangles; }

// A patch of equilateral triangles with one more site, in the middle of a triangle.
test::patch crowded_patch(std::size_t triangle_number) {
  test::patch p = test::make_patch(6, 0);
  const triangle t = p.m.triangles[triangle_number];
  point middle{0, 0};
  for (const vertex_index v : t) {
    middle.x += p.m.sites[v].position.x / 3;
    middle.y += p.m.sites[v].position.y / 3;
  }
  const auto added = static_cast<vertex_index>(p.m.sites.size());
  p.m.sites.push_back({middle, test::round_metric});
  p.m.triangles[triangle_number] = {t[0], t[1], added};
  p.m.triangles.push_back({t[1], t[2], added});
  p.m.triangles.push_back({t[2], t[0], added});
  return p;
}

// Improves the patch by local changes in its own metric. Only faces for which `allowed` is true may
// change.
adapting::editable_mesh improved(const test::patch& p, const adapting::face_test& allowed) {
  auto built = adapting::editable_mesh::build(p.d, p.m);
  REQUIRE(built.ok());
  adapting::editable_mesh m = std::move(built).value();
  adapting::unit_mesh_remesher(m, {}).improve(
      [](const point&, vertex_index&) { return test::round_metric; }, allowed);
  return m;
}

}  // namespace

TEST_CASE("improvement: a site in the middle of a good triangle goes, and nothing else") {
  const test::patch p = crowded_patch(30);
  const auto added = static_cast<vertex_index>(p.m.sites.size() - 1);
  const adapting::editable_mesh m = improved(p, {});
  CHECK(m.at(added).kind == adapting::node_kind::gone);
  CHECK(m.count() + 1 == p.m.sites.size());
  for (vertex_index v = 0; v < added; ++v) CHECK(m.at(v).position == p.m.sites[v].position);
}

TEST_CASE("improvement: a site that is given stays, and so does all where no other face may be") {
  test::patch p = crowded_patch(30);
  const auto none = [](const auto&, const auto&, const auto&) { return false; };
  CHECK(improved(p, none).count() == p.m.sites.size());
  p.m.given = static_cast<vertex_index>(p.m.sites.size());
  p.d.vertices.clear();
  for (const site& s : p.m.sites) p.d.vertices.push_back(s.position);
  const adapting::editable_mesh kept = improved(p, {});
  CHECK(kept.count() == p.m.sites.size());
  for (vertex_index v = 0; v < p.m.sites.size(); ++v)
    CHECK(kept.at(v).position == p.m.sites[v].position);
}

TEST_CASE("improvement: sites on the boundary stay, and every tensor is the field's") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(12), 0.15);
  const mesh_outcome before = mesh_of(d, field, with_passes(0, true)),
                     after = mesh_of(d, field, with_passes(3, true));
  REQUIRE(after.improved);
  CHECK(after.improved->passes > 0);
  const auto on_boundary = [](const mesh& m) {
    std::set<std::pair<double, double>> places;
    for (const boundary_edge& e : m.boundary)
      for (const vertex_index v : {e.a, e.b})
        places.insert({m.sites[v].position.x, m.sites[v].position.y});
    return places;
  };
  CHECK(on_boundary(before.result) == on_boundary(after.result));
  for (const site& s : after.result.sites) CHECK(identical(field.at(s.position).value(), s.metric));
  CHECK_FALSE(after.delivered);
}

TEST_CASE("improvement: with a size, no triangle is too large") {
  const domain d = accepted(square());
  const mesh_outcome after = mesh_of(d, sized(swirl_field(12), 0.1), with_passes(8, true));
  CHECK(after.complete);
  for (const triangle& t : after.result.triangles)
    CHECK(metric_circumradius({after.result.sites[t[0]], after.result.sites[t[1]],
                               after.result.sites[t[2]]}) <= largest_circumradius);
}

TEST_CASE("improvement: with and without a size there are fewer sites, certified and no worse") {
  const domain d = accepted(square());
  for (const bool limit : {false, true}) {
    const formula_field field = limit ? sized(swirl_field(12), 0.2) : swirl_field(12);
    const mesh_outcome before = mesh_of(d, field, with_passes(0, limit));
    const mesh_outcome after = mesh_of(d, field, with_passes(8, limit));
    REQUIRE(before.complete);
    check_not_worse(before, after);
    check_audit(d, after, {});
    CHECK(!before.improved);
    CHECK(after.sites < before.sites);
    CHECK(after.improved->passes > 0);
    CHECK(after.improved->mean_quality_after == measure(after.result).mean_quality);
  }
}

TEST_CASE("improvement: never worse, on domains and metrics of all kinds") {
  const domain slit = with_dangling_segments(), diagonal = with_diagonal(),
               island = island_in_hole(), touching = touching_rings(),
               point = with_isolated_point();
  int compared = 0;
  for (const domain* d : {&slit, &diagonal, &island, &touching, &point})
    for (const formula_field& f : {identity_field(), stretched_to_the_sides()})
      for (const bool limit : {false, true}) {
        const formula_field field = limit ? sized(f, (d->box().high.x - d->box().low.x) / 4) : f;
        INFO(d->vertices.size() << " vertices, metric at 0: " << f.at({0, 0}).value().m11);
        const mesh_outcome before = mesh_of(*d, field, with_passes(0, limit));
        if (!before.complete) continue;
        const mesh_outcome after = mesh_of(*d, field, with_passes(2, limit));
        check_not_worse(before, after);
        check_audit(*d, after, {});
        ++compared;
      }
  CHECK(compared >= 18);
}

TEST_CASE("improvement: the same mesh with one thread and with two") {
  const domain d = with_dangling_segments();
  const auto made_by = [&](std::size_t threads) {
    const internal::thread_limit limit(threads);
    return mesh_of(d, sized(swirl_field(12), 0.12), with_passes(3, true));
  };
  const mesh_outcome one = made_by(1), two = made_by(2);
  CHECK(one.improved->passes > 0);
  CHECK(same(one.result, two.result));
}

TEST_CASE("improvement: scaled by powers of two the same sites go") {
  const mesh_outcome plain = mesh_of(accepted(square()), swirl_field(12), with_passes(3, false));
  for (const double scale : {0x1p-400, 0x1p400}) {
    domain d = square();
    for (point& q : d.vertices) q = {scale * q.x, scale * q.y};
    const formula_field field([scale](const point& q) {
      return swirl_field(12).at({q.x / scale, q.y / scale}).value();
    });
    const mesh_outcome made = mesh_of(accepted(d), field, with_passes(3, false));
    REQUIRE(made.improved);
    CHECK(made.sites == plain.sites);
    CHECK(made.improved->removed == plain.improved->removed);
    CHECK(made.improved->moved == plain.improved->moved);
  }
}

TEST_CASE("improvement: a mesh that is not complete is left alone") {
  mesh_options options = with_passes(5, true);
  options.max_sites = 300;
  const formula_field field = sized(swirl_field(12), 0.05);
  const mesh_outcome after = mesh_of(accepted(square()), field, options);
  options.improve_passes = 0;
  const mesh_outcome before = mesh_of(accepted(square()), field, options);
  CHECK(!before.complete);
  CHECK(!after.improved);
  CHECK(same(before.result, after.result));
  CHECK(ending_text(before) == ending_text(after));
}

// Stops the run at every moment: before the mesh is complete, between passes, and within one.
TEST_CASE("improvement: stopped, the last mesh that was accepted is what there is") {
  const domain d = accepted(square());
  bool while_improving = false;
  for (int most = 1; most < 4000; most *= 2) {
    int asked = 0;
    mesh_options options = with_passes(8, true);
    options.stop = [&]() -> std::optional<std::string> {
      if (++asked > most) return "enough";
      return std::nullopt;
    };
    const mesh_outcome made = mesh_of(d, sized(swirl_field(12), 0.2), options);
    // Only the mesh of the whole run is complete.
    CHECK(made.complete == (made.improved && !made.improved->stopped));
    if (!made.improved) continue;
    CHECK(!made.stopped);
    while_improving = while_improving || made.improved->stopped;
    check_audit(d, made, {});
  }
  CHECK(while_improving);
}
