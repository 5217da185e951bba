// SPDX-License-Identifier: MIT
//
// Fitting: that it lowers what is low where a metric turns fast, that it keeps what is given, and
// that what it proposes is a triangulation, on domains of several kinds.
#include "asterism/mesh/optimize/optimize_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// swirl_field with the aspects of its tensors to a power, and their determinants as they are.
formula_field softened_swirl(double k, double power) {
  return formula_field([k, power](const point& p) {
    const double square = p.x * p.x + p.y * p.y, aspect = std::sqrt(1 + k * square);
    const double across = aspect / std::pow(aspect, power);
    const double f = square > 0 ? (aspect * std::pow(aspect, power) - across) / square : 0;
    return metric_tensor{across + f * p.x * p.x, f * p.x * p.y, across + f * p.y * p.y};
  });
}

mesh_outcome mesh_of(const domain& d, const metric_field& field) {
  mesh_options options;
  options.limit_size = true;
  mesh_outcome made = testing::mesh_of(d, field, options);
  REQUIRE(made.result.disagreeing.empty());
  return made;
}

fitted_domain fitted(const domain& d, const metric_field& field, const mesh& start,
                     const fitting_options& options = {}) {
  auto made = fit(d, field, start, options);
  INFO((made.ok() ? "" : made.failure().message));
  REQUIRE(made.ok());
  return std::move(made).value();
}

// The triangles below 20 degrees with no corner of the domain, as the field measures them.
std::size_t low_in(const mesh& m, const metric_field& field) {
  std::size_t low = 0;
  for (const triangle& t : m.triangles) {
    triangle_sites sites;
    bool at_corner = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const point& q = m.sites[t[i]].position;
      sites[i] = {q, field.at(q).value()};
      at_corner = at_corner || t[i] < m.given;
    }
    if (!at_corner && smallest_angle(sites) < 20) ++low;
  }
  return low;
}

bool same(const fitted_domain& a, const fitted_domain& b) {
  return mesh_fingerprint(a.triangulation) == mesh_fingerprint(b.triangulation) &&
         a.moves == b.moves && a.flips == b.flips;
}

// An L with a hole, an internal segment from a corner of it, and an isolated point.
domain busy_domain() {
  domain d = polygon({{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.5}, {1.5, 4}, {0, 4}});
  add_ring(d, box_ring(0.5, 0.5, 1, 1));
  d.holes = {{0.75, 0.75}};
  add_chain(d, {{2.25, 0.375}, {3.25, 1.125}});
  d.vertices.push_back({0.75, 2.5});
  return accepted(d);
}

formula_field turning_field() {
  return formula_field([](const point& q) {
    const double t = 1.5 * (q.x + q.y), c = std::cos(t), s = std::sin(t);
    return metric_tensor{16 * (9 * c * c + s * s), 16 * (8 * c * s), 16 * (9 * s * s + c * c)};
  });
}

// A triangulation of the domain by the auditor's exact tests, given vertices and segments included.
void check_triangulation(const domain& d, const fitted_domain& f) {
  audit_options options;
  options.original = &d;
  options.check_stars = false;
  const audit_report found = audit(f.triangulation, options);
  for (const audit_finding& finding : found.findings) UNSCOPED_INFO(finding.witness);
  // Regions are numbered afterwards.
  CHECK(found.total_found() == found.found[static_cast<std::size_t>(finding_kind::wrong_region)]);
}

// Not the stars of their sites, by the auditor.
std::size_t star_findings(const fitted_domain& f) {
  const audit_report found = audit(f.triangulation, {});
  REQUIRE(found.stars_checked);
  return found.found[static_cast<std::size_t>(finding_kind::star_neighbour_rejected)] +
         found.found[static_cast<std::size_t>(finding_kind::star_site_missing)];
}

}  // namespace

TEST_CASE("fitting: where a metric turns fast a third of the triangles is low, then hardly any") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(200), 0.17);
  const mesh_outcome start = mesh_of(d, sized(softened_swirl(200, 0.7), 0.17));
  const std::size_t low_before = low_in(start.result, field);
  CHECK(low_before > start.triangles / 4);
  const fitted_domain f = fitted(d, field, start.result);
  CAPTURE(start.triangles, low_before, f.triangulation.triangles.size(), f.low, f.worst_angle,
          f.rounds);
  CHECK(f.low <= 25);
  CHECK(f.triangulation.triangles.size() > 4 * start.triangles / 5);
  CHECK(f.triangulation.triangles.size() < 23 * start.triangles / 20);
  CHECK(f.rounds <= 360);
  CHECK(!f.stopped);
  for (const site& s : f.triangulation.sites) CHECK(s.metric == field.at(s.position).value());
  check_triangulation(d, f);
}

TEST_CASE("fitting: all stars agree in a metric in which refinement gave up") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(100), 0.24);
  const mesh_outcome start = mesh_of(d, sized(softened_swirl(100, 0.7), 0.24));
  CHECK(low_in(start.result, field) > 100);
  const fitted_domain f = fitted(d, field, start.result);
  CHECK(f.low <= 5);
  CHECK(star_findings(f) == 0);
}

TEST_CASE("fitting: given vertices, segments and an isolated point stay, and stars can be made") {
  const domain d = busy_domain();
  const formula_field field = turning_field();
  const mesh_outcome start = mesh_of(d, field);
  const fitted_domain f = fitted(d, field, start.result);
  CAPTURE(start.triangles, f.triangulation.triangles.size(), f.low, f.worst_angle);
  check_triangulation(d, f);
  CHECK(f.low == 0);
  CHECK(star_findings(f) <= 10);
}

TEST_CASE("fitting: domains of every kind come through, in a round metric and a turning one") {
  for (const named_domain& kind : domain_kinds())
    for (const formula_field& field : {sized(identity_field(), 0.5), turning_field()}) {
      if (kind.shape.vertices.size() > 12 && field.at({0, 0}).value().m11 > 100) continue;
      INFO(kind.name);
      const mesh_outcome start = mesh_of(kind.shape, field);
      if (!start.complete) continue;
      const fitted_domain f = fitted(kind.shape, field, start.result);
      check_triangulation(kind.shape, f);
      CHECK(f.low <= f.triangulation.triangles.size() / 20);
    }
}

TEST_CASE("fitting: a good mesh in one metric for all stays about as it is, and good") {
  const domain d = accepted(square());
  const formula_field field = sized(identity_field(), 0.15);
  const mesh_outcome start = mesh_of(d, field);
  REQUIRE(low_in(start.result, field) == 0);
  const fitted_domain f = fitted(d, field, start.result);
  CHECK(f.low == 0);
  CHECK(f.triangulation.triangles.size() > 7 * start.triangles / 10);
  CHECK(f.triangulation.triangles.size() <= start.triangles);
  CHECK(star_findings(f) == 0);
}

TEST_CASE("fitting: the same twice, and scaled by powers of two") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(12), 0.2);
  const mesh_outcome start = mesh_of(d, field);
  const fitted_domain once = fitted(d, field, start.result);
  CHECK(same(once, fitted(d, field, start.result)));
  for (const double scale : {0x1p-400, 0x1p400}) {
    domain scaled = d;
    for (point& q : scaled.vertices) q = {scale * q.x, scale * q.y};
    mesh from = start.result;
    for (site& s : from.sites) s.position = {scale * s.position.x, scale * s.position.y};
    const formula_field there([&](const point& q) {
      const metric_tensor m = field.at({q.x / scale, q.y / scale}).value();
      return metric_tensor{m.m11 / scale / scale, m.m12 / scale / scale, m.m22 / scale / scale};
    });
    const fitted_domain f = fitted(scaled, there, from);
    CHECK(f.low == once.low);
    CHECK(f.triangulation.triangles.size() == once.triangulation.triangles.size());
    CHECK(f.triangulation.triangles == once.triangulation.triangles);
    REQUIRE(f.triangulation.sites.size() == once.triangulation.sites.size());
    for (vertex_index v = 0; v < f.triangulation.sites.size();
         ++v)  // Logarithms of areas are rounded otherwise there.
      CHECK(f.triangulation.sites[v].position.x / scale ==
            Approx(once.triangulation.sites[v].position.x).margin(1e-6));
  }
}

TEST_CASE("fitting: ends when it is told, with what there is") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(12), 0.2);
  const mesh_outcome start = mesh_of(d, field);
  for (const int most : {0, 1, 10, 100}) {
    int asked = 0;
    fitting_options options;
    options.stop = [&]() -> std::optional<std::string> {
      if (++asked > most) return "enough";
      return std::nullopt;
    };
    const fitted_domain f = fitted(d, field, start.result, options);
    CHECK(f.stopped);
    CHECK(asked == most + 1);
    check_triangulation(d, f);
  }
}

TEST_CASE("fitting: what is no triangulation of the domain is refused by name") {
  const domain d = accepted(square());
  const mesh_outcome made = mesh_of(d, sized(identity_field(), 0.5));
  const auto refused = [&](const mesh& m, const std::string& why) {
    const auto f = fit(d, identity_field(), m, {});
    REQUIRE(!f.ok());
    INFO(f.failure().message);
    CHECK(f.failure().message.find(why) != std::string::npos);
  };
  refused({}, "0 sites");
  mesh spoiled = made.result;
  spoiled.triangles.clear();
  refused(spoiled, "no triangles");
  spoiled = made.result;
  spoiled.triangles.pop_back();
  refused(spoiled, "");
  spoiled = made.result;
  spoiled.triangles.push_back(spoiled.triangles[5]);
  refused(spoiled, "");
  spoiled = made.result;
  std::swap(spoiled.triangles[3][0], spoiled.triangles[3][1]);
  refused(spoiled, "does not turn left");
  spoiled = made.result;
  spoiled.triangles[3][0] = 100000;
  refused(spoiled, "is no site");
  spoiled = made.result;
  spoiled.boundary.pop_back();
  refused(spoiled, "one side only");
  spoiled = made.result;
  spoiled.boundary[0].segment = 77;
  refused(spoiled, "of segment 77");
  spoiled = made.result;
  spoiled.sites[7].position.x = std::numeric_limits<double>::quiet_NaN();
  refused(spoiled, "");
  class failing : public metric_field {
   public:
    result<metric_tensor> at(const point&) const override { return error{"nowhere"}; }
  };
  CHECK(fit(d, failing(), made.result, {}).failure().message == "nowhere");
}

// The fitted mesh, which "all stars agree in a metric in which refinement gave up" makes, is the
// last resort; a run comes to it only where no delivered metric is certified.
TEST_CASE(
    "a metric that turns by a radian over an edge is delivered before a mesh is fitted to it") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(100), 0.24);
  mesh_options options;
  options.limit_size = true;
  const mesh_outcome o = make_and_check(d, field, options);
  CHECK(o.complete);
  CHECK_FALSE(o.relaxed.has_value());
  CHECK_FALSE(o.fitted.has_value());
  CHECK(o.delivered.has_value());
}
