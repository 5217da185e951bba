// SPDX-License-Identifier: MIT
//
// Applies elementary changes to a triangulation: in any order, it remains a triangulation of the
// same domain.
#include "asterism/mesh/adapt/editable_mesh.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;
using namespace asterism::testing;

namespace {

mesh plain_mesh(const domain& d) {
  const auto field = make_metric_field("identity", d.box());
  mesh_options options;
  options.angle_bound = 0;
  auto made = make_mesh(d, *field.value(), options);
  REQUIRE(made.ok());
  REQUIRE(made.value().complete);
  return made.value().result;
}

// Checks points 0 to 2 of the audit, and which segments the boundary edges are parts of.
void check_triangulation(const domain& d, const editable_mesh& m) {
  std::vector<vertex_index> renumbered;
  mesh now = m.triangulation(renumbered);
  assign_regions(now, d);
  audit_options options;
  options.check_stars = false;
  options.original = &d;
  const audit_report found = audit(now, options);
  INFO((found.findings.empty() ? "" : found.findings[0].witness));
  CHECK(found.certified);
}

std::uint64_t next(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return state >> 33;
}

// Makes one random change, if one is possible at the place drawn.
void change(editable_mesh& m, std::uint64_t& state) {
  const auto t = static_cast<vertex_index>(next(state) % m.faces().size());
  const std::size_t i = next(state) % 3;
  const face f = m.faces()[t];
  if (!f.exists()) return;
  const point &a = m.at(f.v[after(i)]).position, &b = m.at(f.v[before(i)]).position;
  switch (next(state) % 4) {
    case 0:
      if (const auto place = m.place_on_edge(t, i, {(a.x + b.x) / 2, (a.y + b.y) / 2}))
        if (const auto made = m.split(t, i, *place)) m.set_metric(*made, {1, 0, 1});
      break;
    case 1:
      if (m.can_flip(t, i)) m.flip(t, i);
      break;
    case 2:
      if (m.can_merge(f.v[i], f.v[after(i)])) m.merge(f.v[i], f.v[after(i)]);
      break;
    default:
      if (m.at(f.v[i]).kind == node_kind::free &&
          m.can_move(f.v[i], {(a.x + b.x) / 2, (a.y + b.y) / 2}))
        m.move(f.v[i], {(a.x + b.x) / 2, (a.y + b.y) / 2});
      if (m.at(f.v[i]).kind == node_kind::sliding)
        if (const point to = m.on_segment(f.v[i], a); m.can_move(f.v[i], to)) m.move(f.v[i], to);
  }
}

}  // namespace

TEST_CASE("an editable mesh stays a triangulation under random changes") {
  for (const named_domain& kind : domain_kinds()) {
    INFO(kind.name);
    const domain& d = kind.shape;
    auto built = editable_mesh::build(d, plain_mesh(d));
    REQUIRE(built.ok());
    editable_mesh m = std::move(built).value();
    check_triangulation(d, m);
    std::uint64_t state = 7;
    for (int i = 0; i < 4000; ++i) {
      change(m, state);
      if (i % 500 == 0) check_triangulation(d, m);
    }
    check_triangulation(d, m);
  }
}

TEST_CASE("what divides a chord is on its curve, whatever is changed") {
  // A square with a round hole, and a lens between two cubics.
  domain plate;
  plate.vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {3, 2}};
  plate.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {4, 4, 0}};
  plate.holes = {{2, 2}};
  domain_curve circle;
  circle.centre = {2, 2};
  circle.vertices = {4, 4};
  circle.parameters = {0, 1};
  circle.segment = 4;
  plate.curves = {circle};
  domain lens;
  lens.vertices = {{0, 0}, {1, 0}};
  lens.segments = {{0, 1, 0}, {1, 0, 0}};
  for (const std::uint32_t s : {0u, 1u}) {
    domain_curve cubic;
    cubic.kind = curve_kind::cubic;
    const double y = s == 0 ? -0.5 : 0.5;
    cubic.control = {{{s == 0 ? 0.3 : 0.7, y}, {s == 0 ? 0.7 : 0.3, y}}};
    cubic.vertices = {s, 1 - s};
    cubic.parameters = {0, 1};
    cubic.segment = s;
    lens.curves.push_back(cubic);
  }
  for (const domain& whole : {plate, lens}) {
    const auto divided = divide_curves(whole);
    REQUIRE(divided.ok());
    const domain d = accepted(divided.value());
    auto built = editable_mesh::build(d, plain_mesh(d));
    REQUIRE(built.ok());
    editable_mesh m = std::move(built).value();
    std::uint64_t state = 5;
    for (int i = 0; i < 3000; ++i) change(m, state);
    std::vector<vertex_index> renumbered;
    mesh now = m.triangulation(renumbered);
    assign_regions(now, d);
    audit_options options;
    options.check_stars = false;
    options.original = &d;
    const audit_report found = audit(now, options);
    INFO((found.findings.empty() ? "" : found.findings[0].witness));
    CHECK(found.certified);
    CHECK(found.curves.off_curve == 0);
    CHECK(found.curves.vertices > d.vertices.size() + 5);
  }
}

TEST_CASE("given nodes and segments are never merged away") {
  const domain d = accepted(square());
  auto built = editable_mesh::build(d, plain_mesh(d));
  REQUIRE(built.ok());
  const editable_mesh& m = built.value();
  for (vertex_index v = 0; v < d.vertices.size(); ++v) {
    face_list ring;
    m.neighbours(v, ring);
    for (const vertex_index w : ring) CHECK_FALSE(m.can_merge(v, w));
  }
}
