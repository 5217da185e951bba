// SPDX-License-Identifier: MIT
//
// Makes the next mesh of a loop: vertices come and go, the domain stays, and a second adaptation to
// the same metric changes nothing.
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"
#include "asterism/mesh/transfer/transfer.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using tests::divided_mesh;
using tests::sample_mesh;

namespace {

double front(const point& q) { return std::tanh(10 * (q.x * q.x + q.y * q.y - 0.5)); }

marked_mesh with_metric(mesh m, double vertices) {
  nodal_values u{"u", {}};
  for (const site& s : m.sites) u.values.push_back(front(s.position));
  solution_metric_options wishes;
  wishes.vertices = vertices;
  wishes.gradation = 1.5;
  auto metric = make_solution_metric(m, {u}, wishes);
  REQUIRE(metric.ok());
  for (std::size_t v = 0; v < m.sites.size(); ++v) m.sites[v].metric = metric.value().tensors[v];
  return {std::move(m), {}};
}

adapted_mesh adapted(const marked_mesh& from, std::optional<std::size_t> vertices = {}) {
  mesh_adaptation_options options;
  options.refinement.vertices = vertices;
  auto next = adapt_to_metric(from, options);
  INFO((next.ok() ? "" : next.failure().message));
  REQUIRE(next.ok());
  return std::move(next).value();
}

}  // namespace

TEST_CASE("vertices come and go, and the number wanted is there") {
  for (const double wanted : {150.0, 900.0}) {
    const auto next =
        adapted(with_metric(sample_mesh(20), wanted), static_cast<std::size_t>(wanted));
    CHECK(next.made.certified());
    CHECK_FALSE(next.kept);
    CHECK(next.shape.vertices.size() == 4);
    const auto sites = static_cast<double>(next.made.outcome.result.sites.size());
    CHECK(std::abs(sites / wanted - 1) < 0.05);
  }
}

TEST_CASE("new boundary vertices are on cubics through the old ones, and how far is proved") {
  // A circle of 40 triangles around a vertex, to be meshed with edges a tenth as long.
  marked_mesh disc;
  constexpr vertex_index n = 40;
  for (vertex_index i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    disc.subject.sites.push_back({{std::cos(t), std::sin(t)}, {1600, 0, 1600}});
    disc.subject.triangles.push_back({i, (i + 1) % n, n});
    disc.subject.boundary.push_back({i, (i + 1) % n, i, 1});
  }
  disc.subject.sites.push_back({{0, 0}, {1600, 0, 1600}});
  const double height = 1 - std::cos(std::numbers::pi / n);
  for (const bool is_limited : {false, true}) {
    mesh_adaptation_options options;
    options.refinement.vertices = 3000;
    if (is_limited) options.largest_boundary_distance = height / 2;
    const auto next = adapt_to_metric(disc, options);
    REQUIRE(next.ok());
    const adapted_mesh& made = next.value();
    REQUIRE(made.made.certified());
    const mesh& m = made.made.outcome.result;
    double off = 0;
    for (const boundary_edge& e : m.boundary) {
      const point& p = m.sites[e.a].position;
      off = std::max(off, std::abs(std::hypot(p.x, p.y) - 1));
    }
    CHECK(m.boundary.size() >= 4 * n);
    if (is_limited) {
      CHECK(made.boundary_distance <= height / 2);
      CHECK(off > height / 2);
    } else {
      CHECK(off < 1e-8);
      CHECK(made.boundary_distance >= height * (1 - 1e-6));
      CHECK(made.boundary_distance <= height * (1 + 1e-6));
    }
    const certificate& claim = made.made.claim;
    CHECK(claim.former_distance.largest_distance == made.boundary_distance);
    const auto again = parse_certificate(certificate_text(claim), "text");
    REQUIRE(again.ok());
    CHECK(verify(m, again.value(), {}).verified);
    certificate forged = again.value();
    forged.former_distance.largest_distance *= 0.99;
    CHECK_FALSE(verify(m, forged, {}).verified);
    forged = again.value();
    forged.former->allowed = made.boundary_distance / 2 + 1e-12;
    CHECK(verify(m, forged, {}).verified == (made.boundary_distance < 1e-11));
  }
}

// Chords as long as the metric wants along a curve are too coarse: the computed drag of a cylinder
// with 68 edges is then off by 5e-4.
TEST_CASE("chords of cubics are as near to them as the size across wants") {
  // A ring between two boundaries of 24 edges each, in a metric that wants thin triangles along
  // them.
  marked_mesh ring;
  constexpr vertex_index n = 24;
  constexpr double along = 0.25, across = 0.06;
  for (const double radius : {1.0, 2.0})
    for (vertex_index i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * i / n, c = std::cos(t), s = std::sin(t);
      const double in = 1 / (across * across), round = 1 / (along * along);
      ring.subject.sites.push_back(
          {{radius * c, radius * s},
           {in * c * c + round * s * s, (in - round) * c * s, in * s * s + round * c * c}});
    }
  for (vertex_index i = 0; i < n; ++i) {
    const vertex_index j = (i + 1) % n;
    ring.subject.triangles.push_back({i, n + i, n + j});
    ring.subject.triangles.push_back({i, n + j, j});
    ring.subject.boundary.push_back({n + i, n + j, i, 1});
    ring.subject.boundary.push_back({j, i, i, 2});
  }
  const auto made = adapted(ring);
  REQUIRE(made.made.certified());
  const mesh& m = made.made.outcome.result;
  double highest = 0, off = 0;
  for (const boundary_edge& e : m.boundary) {
    const point &p = m.sites[e.a].position, &q = m.sites[e.b].position;
    const double radius = e.marker == 1 ? 2 : 1, length = std::hypot(q.x - p.x, q.y - p.y);
    off = std::max(off, std::abs(std::hypot(p.x, p.y) - radius));
    if (length > 0.8 * along) highest = std::max(highest, length * length / (8 * radius));
  }
  CHECK(off < 1e-5);
  // Chords of length one on the inner ring would be 0.0078 from it.
  CHECK(highest <= across / 100 * 1.05);
  const auto again = parse_certificate(certificate_text(made.made.claim), "text");
  REQUIRE(again.ok());
  CHECK(verify(m, again.value(), {}).verified);
}

TEST_CASE("a metric that turns by any angle over an edge is delivered about as dense as wanted") {
  mesh m = sample_mesh(30);
  for (site& s : m.sites) {
    const double turn = 400 * (s.position.x + s.position.y * s.position.y);
    const double c = std::cos(turn), d = std::sin(turn), high = 900, low = 900.0 / 200 / 200;
    s.metric = {high * c * c + low * d * d, (high - low) * c * d, high * d * d + low * c * c};
  }
  const auto next = adapted({std::move(m), {}});
  CHECK(next.made.certified());
  REQUIRE(next.made.outcome.delivered);
  const delivered_report& delivered = *next.made.outcome.delivered;
  // Bounds what clipping the distortion between neighbours may change: a metric four times as
  // dense, with half of its tensors changed, is a fault.
  CHECK(delivered.median < most_median_distance);
  CHECK(delivered.complexity_delivered < 1.5 * delivered.complexity_wanted);
  CHECK(delivered.complexity_delivered > delivered.complexity_wanted / 1.5);
  CHECK(next.made.outcome.complete);
}

TEST_CASE("without a number wanted there are as many vertices as unit edges take") {
  mesh m = sample_mesh(12);
  constexpr double h = 0.07;
  for (site& s : m.sites) s.metric = {1 / (h * h), 0, 1 / (h * h)};
  const auto next = adapted({m, {}});
  REQUIRE(next.made.certified());
  // The square of side 2 holds 4 / (h^2 sqrt(3) / 4) unit triangles and has 8 / h unit edges on its
  // boundary.
  const double wanted = 8 / std::sqrt(3.0) / (h * h) + 4 / h + 1;
  const auto sites = static_cast<double>(next.made.outcome.result.sites.size());
  CHECK(std::abs(sites / wanted - 1) < 0.03);
}

TEST_CASE("a metric that asks for billions of vertices ends at the limit on sites") {
  mesh m = sample_mesh(6);
  for (site& s : m.sites) s.metric = {1e12, 0, 1e12};
  mesh_adaptation_options options;
  options.refinement.max_sites = 3000;
  const auto next = adapt_to_metric({m, {}}, options);
  REQUIRE(next.ok());
  const auto& made = next.value().made.outcome;
  CHECK_FALSE(made.complete);
  CHECK(made.result.sites.size() <= 3000);
  CHECK(made.result.sites.size() > 1000);
}

TEST_CASE("the loop in values: solution, Hessian, metric, mesh, solution, each with its report") {
  marked_mesh old{sample_mesh(20), {}};
  solution u{old.subject.sites.size(), {{"u", field_kind::scalar, {}}}};
  for (const site& s : old.subject.sites) u.fields[0].values.push_back(front(s.position));
  const auto hessian = recover_hessian(old.subject, u.fields[0].values, {});
  REQUIRE(hessian.ok());
  CHECK(hessian.value().at.size() == old.subject.sites.size());
  solution_metric_options wishes;
  wishes.vertices = 300;
  const auto metric = make_solution_metric(old.subject, {{"u", u.fields[0].values}}, wishes);
  REQUIRE(metric.ok());
  CHECK(metric.value().report.reached);
  for (std::size_t v = 0; v < old.subject.sites.size(); ++v)
    old.subject.sites[v].metric = metric.value().tensors[v];
  mesh_adaptation_options options;
  options.refinement.vertices = 300;
  const auto next = adapt_to_metric(old, options);
  REQUIRE(next.ok());
  CHECK(next.value().made.certified());
  const auto moved =
      transfer_solution(old.subject, u, next.value().made.outcome.result, transfer_method::project);
  REQUIRE(moved.ok());
  const transferred_component& c = moved.value().report.components[0];
  CHECK(c.integral_after == Approx(c.integral_before).epsilon(1e-13));
}

TEST_CASE("adapting twice with the metric delivered changes nothing") {
  const auto first = adapted(with_metric(sample_mesh(20), 400));
  REQUIRE(first.made.certified());
  const auto second = adapted({first.made.outcome.result, {}});
  CHECK(second.kept);
  CHECK(second.made.certified());
  CHECK(mesh_fingerprint(second.made.outcome.result) ==
        mesh_fingerprint(first.made.outcome.result));
}

TEST_CASE("the mesh delivered for a front stays, though edges are short where it bends") {
  const auto first = adapted(with_metric(sample_mesh(30), 1500), 1500);
  REQUIRE(first.made.certified());
  const auto second = adapted({first.made.outcome.result, {}});
  CHECK(second.kept);
}

namespace {

// A mesh of equal sizes, with the metric of u = exp(5x) cos(5y), which is the same in all
// directions.
marked_mesh with_harmonic_metric(std::size_t vertices) {
  mesh m = sample_mesh(16);
  for (site& s : m.sites) s.metric = {1, 0, 1};
  m = adapted({m, {}}, vertices).made.outcome.result;
  nodal_values u{"u", {}};
  for (const site& s : m.sites)
    u.values.push_back(std::exp(5 * s.position.x) * std::cos(5 * s.position.y));
  solution_metric_options wishes;
  wishes.hessian = hessian_method::least_squares;  // smooth, so that the mesh is certified in it
  wishes.vertices = static_cast<double>(m.sites.size());
  auto metric = make_solution_metric(m, {u}, wishes);
  REQUIRE(metric.ok());
  for (std::size_t v = 0; v < m.sites.size(); ++v) m.sites[v].metric = metric.value().tensors[v];
  return {std::move(m), {}};
}

}  // namespace

TEST_CASE("a mesh stays only where its lengths are those of a new one, unless it is to") {
  const marked_mesh from = with_harmonic_metric(500);
  mesh_adaptation_options options;
  options.refinement.vertices = from.subject.sites.size();
  const auto by_rule = [&](keep_rule rule) {
    options.keep = rule;
    auto next = adapt_to_metric(from, options);
    REQUIRE(next.ok());
    CHECK(next.value().made.certified());
    return std::move(next).value();
  };
  const auto automatic = by_rule(keep_rule::automatic);
  CHECK_FALSE(automatic.kept);
  CHECK(automatic.made.claim.measured.at("unit_edges") > 0.95);
  CHECK_FALSE(by_rule(keep_rule::never).kept);
  const auto always = by_rule(keep_rule::always);
  CHECK(always.kept);
  CHECK(always.made.claim.measured.at("unit_edges") < 0.5);
}

TEST_CASE("a mesh that is as good as a new one is made anew where that is asked for") {
  const auto first = adapted(with_metric(sample_mesh(20), 400));
  mesh_adaptation_options options;
  options.keep = keep_rule::never;
  const auto second = adapt_to_metric({first.made.outcome.result, {}}, options);
  REQUIRE(second.ok());
  CHECK_FALSE(second.value().kept);
  CHECK(second.value().made.certified());
}

TEST_CASE("a loop that asks for a tenth more each time gets it each time") {
  mesh m = adapted(with_metric(sample_mesh(20), 400), 400).made.outcome.result;
  for (double wanted = 440; wanted < 800; wanted *= 1.1) {
    const auto next = adapted(with_metric(m, wanted), static_cast<std::size_t>(wanted));
    CHECK(next.made.certified());
    CHECK_FALSE(next.kept);
    m = next.made.outcome.result;
    CHECK(static_cast<double>(m.sites.size()) == Approx(wanted).epsilon(0.04));
  }
}

namespace {

// Returns a closed curve around the origin, as ragged as a coast: midpoints are displaced
// repeatedly.
domain ragged_domain(std::size_t count) {
  std::vector<double> radii(8, 1.0);
  std::uint64_t state = 7;
  while (radii.size() < count) {
    const double most = 0.3 * std::pow(8.0 / static_cast<double>(radii.size()), 0.9);
    std::vector<double> finer;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      const double part = static_cast<double>(state >> 11U) * 0x1p-52 - 1;
      finer.push_back(radii[i]);
      finer.push_back((radii[i] + radii[(i + 1) % radii.size()]) / 2 + most * part);
    }
    radii = finer;
  }
  domain d;
  const auto n = static_cast<vertex_index>(radii.size());
  for (vertex_index i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / n;
    d.vertices.push_back({radii[i] * std::cos(angle), radii[i] * std::sin(angle)});
    d.segments.push_back({i, (i + 1) % n, 1});
  }
  const auto checked = check_domain(d);
  REQUIRE(checked.ok());
  return checked.value();
}

// Returns a mesh of a coast with a smooth metric.
mesh coast_with_metric() {
  const domain coast = ragged_domain(1024);
  mesh_options fine;
  fine.limit_size = true;
  const auto field = make_metric_field("identity", coast.box(), 0.03);
  REQUIRE(field.ok());
  const auto first = make_certified_mesh(coast, *field.value(), fine, {});
  REQUIRE(first.ok());
  REQUIRE(first.value().certified());
  mesh m = first.value().outcome.result;
  for (site& s : m.sites) {
    const double size = 0.1 + 0.03 * std::sin(3 * s.position.x);
    s.metric = {1 / (size * size), 0, 1 / (size * size)};
  }
  return m;
}

}  // namespace

TEST_CASE("a boundary finer than the metric has as many vertices as are wanted, at once") {
  const mesh m = coast_with_metric();
  constexpr std::size_t wanted = 3000;
  const auto next = adapted({m, {}}, wanted);
  CHECK(next.made.certified());
  REQUIRE(next.made.outcome.delivered);
  // With 4,000, more than the metric takes, the smoothest metric tried had 0.37 where this one had
  // 0.5.
  CHECK(next.made.claim.measured.at("unit_edges") > 0.7);
  CHECK(static_cast<double>(next.made.outcome.result.sites.size()) ==
        Approx(static_cast<double>(wanted)).epsilon(0.03));
}

// With so few vertices no mesh of a coast of 4,096 vertices meets the angle bound, however smooth
// the metric. Attempts with ever smoother metrics take 11 seconds in vain. For 6,000 wanted
// vertices they lead to 15,952, with a share of unit edges of 0.41; without them there are 11,467,
// with 0.70.
TEST_CASE("fewer vertices than a coast needs are known to be too few at once") {
  const auto next = adapted({coast_with_metric(), {}}, 1200);
  CHECK(next.made.certified());
  CHECK(next.made.outcome.delivered);
  INFO(next.made.outcome.sites << " sites");
  CHECK(next.made.outcome.sites < 3000);
}

TEST_CASE("markers, regions and internal segments stay") {
  const auto next = adapted(with_metric(divided_mesh(16), 500));
  CHECK(next.made.certified());
  const mesh& m = next.made.outcome.result;
  bool has_internal = false;
  for (const boundary_edge& e : m.boundary)
    has_internal = has_internal || (e.internal && e.marker == 5);
  CHECK(has_internal);
  CHECK(std::count(m.regions.begin(), m.regions.end(), 2) > 50);
  CHECK(std::count(m.regions.begin(), m.regions.end(), -7) > 50);
}
