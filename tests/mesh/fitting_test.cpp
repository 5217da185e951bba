// SPDX-License-Identifier: MIT
//
// Fitting: that it lowers what is low where a metric turns fast, that it keeps what is given, and
// that what it proposes can be refined from, on domains of several kinds.
#include "asterism/mesh/fitting.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "asterism/mesh/consistency.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/refine_quality.hpp"
#include "asterism/mesh/refine_state.hpp"
#include "domain_kinds.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

formula_field sized(const formula_field& field, double size) {
  return formula_field([field, size](const point& q) {
    const metric_tensor m = field.at(q).value();
    const double s = 1 / (size * size);
    return metric_tensor{s * m.m11, s * m.m12, s * m.m22};
  });
}

// swirl_field with the aspects of its tensors to a power, and their determinants as they are.
formula_field softened_swirl(double k, double power) {
  return formula_field([k, power](const point& p) {
    const double square = p.x * p.x + p.y * p.y, aspect = std::sqrt(1 + k * square);
    const double across = aspect / std::pow(aspect, power);
    const double f = square > 0 ? (aspect * std::pow(aspect, power) - across) / square : 0;
    return metric_tensor{across + f * p.x * p.x, f * p.x * p.y, across + f * p.y * p.y};
  });
}

refinement_outcome mesh_of(const domain& d, const metric_field& field) {
  refinement_options options;
  options.limit_size = true;
  auto made = make_mesh(d, field, options);
  REQUIRE(made.ok());
  REQUIRE(made.value().result.disagreeing.empty());
  return std::move(made).value();
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

std::size_t sites_of(const fitted_domain& f, const domain& d) {
  std::size_t count = d.vertices.size() + f.proposed.interior.size();
  for (const auto& division : f.proposed.divisions) count += division.size();
  return count;
}

bool same(const fitted_domain& a, const fitted_domain& b) {
  return a.proposed.divisions == b.proposed.divisions &&
         a.proposed.interior == b.proposed.interior && a.moves == b.moves && a.flips == b.flips;
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

// Each division in order between the ends of its segment, on it up to rounding.
void check_divisions(const domain& d, const fitted_domain& f) {
  REQUIRE(f.proposed.divisions.size() == d.segments.size());
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const point &a = d.vertices[d.segments[s].a], &b = d.vertices[d.segments[s].b];
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    double before = 0;
    for (const site& m : f.proposed.divisions[s]) {
      const double x = m.position.x - a.x, y = m.position.y - a.y;
      const double along = (x * dx + y * dy) / square;
      CHECK(along > before);
      CHECK(along < 1);
      CHECK(std::abs(x * dy - y * dx) <= 1e-14 * square);
      before = along;
    }
  }
}

struct exact_result {
  std::size_t sites = 0, agreeing = 0, disagreeing = 0;
};

// The stars of what is proposed, each held against all sites.
exact_result stars_of(const domain& d, const metric_field& field, const fitted_domain& f) {
  const filtered_kernel arithmetic;
  const star_kernel_on<filtered_kernel> kernel(arithmetic);
  auto state = refine_state::start_filled(d, field, kernel, 100000, f.proposed);
  REQUIRE(state.ok());
  std::vector<index> all;
  for (index v = 0; v < state.value().sites().size(); ++v) all.push_back(v);
  state.value().stars().construct(state.value().oracle(), all, star_search::thorough);
  const auto report = check_consistency(state.value().oracle(), state.value().stars());
  return {state.value().sites().size(), report.agreeing.size(), report.disagreeing.size()};
}

}  // namespace

TEST_CASE("fitting: where a metric turns fast a third of the triangles is low, then hardly any") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(200), 0.17);
  const refinement_outcome start = mesh_of(d, sized(softened_swirl(200, 0.7), 0.17));
  const std::size_t low_before = low_in(start.result, field);
  CHECK(low_before > start.triangles / 4);
  const fitted_domain f = fitted(d, field, start.result);
  CAPTURE(start.triangles, low_before, f.triangles, f.low, f.worst_angle, f.rounds);
  CHECK(f.low <= 25);
  CHECK(f.triangles > 4 * start.triangles / 5);
  CHECK(f.triangles < 23 * start.triangles / 20);
  CHECK(f.rounds <= 360);
  CHECK(!f.stopped);
  // As many triangles as Euler asks for: 2 inner + those on the boundary - 2.
  const std::size_t inner = f.proposed.interior.size();
  CHECK(f.triangles == 2 * inner + (sites_of(f, d) - inner) - 2);
  for (const site& s : f.proposed.interior) CHECK(s.metric == field.at(s.position).value());
  check_divisions(d, f);
}

TEST_CASE("fitting: all stars agree in a metric in which refinement gave up") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(100), 0.24);
  const refinement_outcome start = mesh_of(d, sized(softened_swirl(100, 0.7), 0.24));
  CHECK(low_in(start.result, field) > 100);
  const fitted_domain f = fitted(d, field, start.result);
  CHECK(f.low <= 5);
  const exact_result exact = stars_of(d, field, f);
  CHECK(exact.sites == sites_of(f, d));
  CHECK(exact.agreeing == f.triangles);
  CHECK(exact.disagreeing == 0);
}

TEST_CASE("fitting: given vertices, segments and an isolated point stay, and stars can be made") {
  const domain d = busy_domain();
  const formula_field field = turning_field();
  const refinement_outcome start = mesh_of(d, field);
  const fitted_domain f = fitted(d, field, start.result);
  CAPTURE(start.triangles, f.triangles, f.low, f.worst_angle);
  check_divisions(d, f);
  CHECK(f.low == 0);
  const exact_result exact = stars_of(d, field, f);
  CAPTURE(exact.sites, exact.agreeing, exact.disagreeing);
  CHECK(exact.sites >= sites_of(f, d));
  CHECK(exact.disagreeing <= 10);
  CHECK(exact.agreeing + 10 >= f.triangles);
}

TEST_CASE("fitting: domains of every kind come through, in a round metric and a turning one") {
  for (const named_domain& kind : domain_kinds())
    for (const formula_field& field : {sized(identity_field(), 0.5), turning_field()}) {
      if (kind.shape.vertices.size() > 12 && field.at({0, 0}).value().m11 > 100) continue;
      INFO(kind.name);
      const refinement_outcome start = mesh_of(kind.shape, field);
      if (!start.complete) continue;
      const fitted_domain f = fitted(kind.shape, field, start.result);
      check_divisions(kind.shape, f);
      CHECK(f.low <= f.triangles / 20);
    }
}

TEST_CASE("fitting: a good mesh in one metric for all stays about as it is, and good") {
  const domain d = accepted(square());
  const formula_field field = sized(identity_field(), 0.15);
  const refinement_outcome start = mesh_of(d, field);
  REQUIRE(low_in(start.result, field) == 0);
  const fitted_domain f = fitted(d, field, start.result);
  CHECK(f.low == 0);
  CHECK(f.triangles > 7 * start.triangles / 10);
  CHECK(f.triangles <= start.triangles);
  CHECK(stars_of(d, field, f).disagreeing == 0);
}

TEST_CASE("fitting: the same twice, and scaled by powers of two") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(12), 0.2);
  const refinement_outcome start = mesh_of(d, field);
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
    CHECK(f.triangles == once.triangles);
    REQUIRE(f.proposed.interior.size() == once.proposed.interior.size());
    CHECK(f.proposed.interior[0].position.x / scale == once.proposed.interior[0].position.x);
  }
}

TEST_CASE("fitting: ends when it is told, with what there is") {
  const domain d = accepted(square());
  const formula_field field = sized(swirl_field(12), 0.2);
  const refinement_outcome start = mesh_of(d, field);
  for (const int most : {0, 1, 10, 100}) {
    int asked = 0;
    fitting_options options;
    options.enough = [&] { return ++asked > most; };
    const fitted_domain f = fitted(d, field, start.result, options);
    CHECK(f.stopped);
    CHECK(asked == most + 1);
    CHECK(f.proposed.complete);
    check_divisions(d, f);
  }
}

TEST_CASE("fitting: what is no triangulation of the domain is refused by name") {
  const domain d = accepted(square());
  const refinement_outcome made = mesh_of(d, sized(identity_field(), 0.5));
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
