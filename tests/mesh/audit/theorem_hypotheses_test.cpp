// SPDX-License-Identifier: MIT
//
// Compares the hypotheses of the theorem on nets, measured on a mesh, with all pairs of sites and
// many points in extended precision. Meshes that do not meet a hypothesis are refused.
#include "asterism/mesh/audit/theorem_hypotheses.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <tuple>

#include "asterism/core/random.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/theorem_measures.hpp"
#include "asterism/mesh/audit/theorem_table.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::test;
using Catch::Contains;

namespace {

using real = long double;
using vertex_number = asterism::vertex_index;

mesh meshed_square(const std::string& metric, double size) {
  const auto shape = check_domain(load_domain("square").value()).value();
  const auto field = make_metric_field(metric, shape.box(), size);
  mesh_options options;
  options.limit_size = true;
  return make_mesh(shape, *field.value(), options).value().result;
}

real distance(const site& s, const point& q) {
  const real x = real(q.x) - s.position.x, y = real(q.y) - s.position.y;
  return std::sqrt(s.metric.m11 * x * x + 2 * s.metric.m12 * x * y + s.metric.m22 * y * y);
}

// Computes with 100 digits: nearly equal eigenvalues lose half of them.
real distortion(const metric_tensor& p, const metric_tensor& q) {
  using number = boost::multiprecision::cpp_bin_float_100;
  const auto determinant = [](const metric_tensor& m) {
    return number(m.m11) * m.m22 - number(m.m12) * m.m12;
  };
  const number mixed = number(p.m22) * q.m11 - 2 * number(p.m12) * q.m12 + number(p.m11) * q.m22;
  const number half = mixed / determinant(p) / 2, product = determinant(q) / determinant(p);
  const number square = half * half - product;
  const number greatest = square > 0 ? number(half + sqrt(square)) : half;
  const number inverse = greatest / product;
  return static_cast<real>(sqrt(std::max({number(1), greatest, inverse})));
}

real nearest_distance(const mesh& m, const point& q) {
  real nearest = std::numeric_limits<real>::infinity();
  for (const site& s : m.sites) nearest = std::min(nearest, distance(s, q));
  return nearest;
}

}  // namespace

TEST_CASE("the theorem applies to a filled square in a metric that varies slowly") {
  for (const auto& [metric, size, angle] :
       {std::tuple{"identity", 0.1, 29.0}, {"sink:3", 0.05, 20.0}, {"swirl:3", 0.05, 15.0}}) {
    const theorem_hypotheses h = measure_theorem_hypotheses(meshed_square(metric, size), angle);
    INFO(metric << ": " << h.reason);
    CHECK(h.applies);
    CHECK(h.proved_angle >= angle);
    CHECK(h.covering_radius <= 0.751);
    CHECK(h.reason == "all hypotheses hold");
    CHECK((h.sigma_eps == 0) == (std::string(metric) == "identity"));
  }
}

TEST_CASE("what is measured of the hypotheses is no better than it is") {
  for (const char* metric : {"identity", "swirl:3", "sink:12", "linear"}) {
    const mesh m = meshed_square(metric, std::string(metric) == "linear" ? 1 : 0.2);
    const theorem_hypotheses h = measure_theorem_hypotheses(m, 1);
    INFO(metric << ": " << h.reason);
    splitmix64 random(3);
    for (int k = 0; k < 2000; ++k) {
      const point q{random.real(-1, 1), random.real(-1, 1)};
      CHECK(nearest_distance(m, q) <= h.covering_radius);
    }
    if (Contains("metrics of").match(h.reason)) continue;  // measuring ended before the last pair
    const auto radius = static_cast<real>(h.covering_radius);
    for (std::size_t i = 0; i < m.sites.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const site &p = m.sites[i], &q = m.sites[j];
        const real from_p = distance(p, q.position), from_q = distance(q, p.position);
        // The disks of two sites certainly meet if the middle of the segment between the sites is
        // in both.
        if (from_p / 2 > radius || from_q / 2 > radius) continue;
        const real tau = distortion(p.metric, q.metric);
        CHECK(tau <= h.distortion);
        CHECK((1 - 1 / tau) / std::min(from_p, from_q) <= h.variation + 1e-15);
        CHECK(h.spacing <= std::max(from_p, from_q));
      }
    for (const boundary_edge& e : m.boundary)
      CHECK(distance(m.sites[e.a], m.sites[e.b].position) <= h.longest_subsegment);
  }
}

// Bounds computed from squared lengths leave the range of doubles at such sizes, and each site is
// then compared with all others: a square with a size of 1e-150 takes 18 times as long as one with
// 1e-7, and the answer is "not all was measured".
TEST_CASE("lengths of extreme size are measured and audited as ordinary ones are") {
  const mesh ordinary = meshed_square("swirl:3", 0.05);
  const theorem_hypotheses known = measure_theorem_hypotheses(ordinary, 15);
  audit_options asked;
  asked.angle_bound = 15;
  const audit_report judged = audit(ordinary, asked);
  REQUIRE(known.applies);
  REQUIRE(judged.certified);
  for (const auto& [of_coordinates, of_lengths] :
       {std::pair{0, 490}, {0, -490}, {400, 0}, {-400, 0}, {400, -40}, {-330, 160}}) {
    mesh extreme = ordinary;
    for (site& s : extreme.sites) {
      s.position = {std::ldexp(s.position.x, of_coordinates),
                    std::ldexp(s.position.y, of_coordinates)};
      for (double* entry : {&s.metric.m11, &s.metric.m12, &s.metric.m22})
        *entry = std::ldexp(*entry, 2 * (of_lengths - of_coordinates));
    }
    INFO(of_coordinates << ", " << of_lengths);
    const theorem_hypotheses h = measure_theorem_hypotheses(extreme, 15);
    CHECK(h.applies);
    CHECK(h.reason == known.reason);
    CHECK(h.covering_radius == std::ldexp(known.covering_radius, of_lengths));
    CHECK(h.spacing == std::ldexp(known.spacing, of_lengths));
    CHECK(h.longest_subsegment == std::ldexp(known.longest_subsegment, of_lengths));
    CHECK(h.variation == std::ldexp(known.variation, -of_lengths));
    CHECK(h.distortion == known.distortion);
    CHECK(h.proved_angle == known.proved_angle);
    const audit_report again = audit(extreme, asked);
    CHECK(again.certified);
    CHECK(again.worst().degrees == judged.worst().degrees);
    CHECK(again.exact_decisions == judged.exact_decisions);
  }
}

TEST_CASE("the theorem does not apply where sites are too near to each other") {
  patch p = make_patch(8, 0);
  CHECK(measure_theorem_hypotheses(p.m, 20).applies);
  // The triangles stay counter-clockwise.
  site& inner = p.m.sites[p.at(4, 4)];
  inner.position.x += 0.6;
  const theorem_hypotheses h = measure_theorem_hypotheses(p.m, 20);
  CHECK_FALSE(h.applies);
  CHECK(h.spacing <= 0.4001);
  CHECK_THAT(h.reason, Contains("apart, where the domain is covered within"));
  CHECK_THAT(h.reason, Contains("vertex " + std::to_string(p.at(4, 4) + 1) + " "));
}

// Each of 2,000 random sites is near hundreds of others. Comparing all these pairs takes a third of
// a run, and is not needed: one short edge shows that the theorem does not apply.
TEST_CASE(
    "of random sites all near pairs were measured, where a few edges told that it does not apply") {
  const auto shape =
      check_domain(add_random_points(load_domain("square").value(), 2000, 1).value()).value();
  const auto field = make_metric_field("linear", shape.box(), 1);
  mesh_options options;
  options.angle_bound = 0;
  const mesh m = make_mesh(shape, *field.value(), options).value().result;
  const cancellation account = cancellation().with_work(1e9);
  const theorem_hypotheses h = measure_theorem_hypotheses(m, 20, account);
  CHECK_FALSE(h.applies);
  // The work shows that only the neighbourhoods of subsegments were searched.
  CHECK(1e9 - account.units_left() < 0.05 * 10 * static_cast<double>(m.sites.size()));
  real least = std::numeric_limits<real>::infinity();
  for (std::size_t i = 0; i < m.sites.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, std::max(distance(m.sites[i], m.sites[j].position),
                                       distance(m.sites[j], m.sites[i].position)));
  CHECK(h.spacing >= least * (1 - 1e-9L));
}

TEST_CASE("the theorem does not apply where the metric jumps") {
  patch p = make_patch(8, 0);
  p.m.sites[p.at(4, 4)].metric = {2, 0, 0.5};
  const theorem_hypotheses h = measure_theorem_hypotheses(p.m, 20);
  CHECK_FALSE(h.applies);
  CHECK(h.distortion >= 1.414);
  CHECK_THAT(h.reason, Contains("differ by a factor of"));
}

TEST_CASE("the theorem does not apply where a site may encroach on a boundary edge") {
  // A row of triangles a little lower than half of a boundary edge.
  const mesh low = make_mesh_of({{0, 0}, {1, 0}, {0.5, 0.49}, {0, 1}, {1, 1}},
                                {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {3, 2, 4}});
  const theorem_hypotheses h = measure_theorem_hypotheses(low, 1);
  CHECK_FALSE(h.applies);
  CHECK_THAT(h.reason, Contains("vertex 3 may be as near to a point of the boundary edge"));
}

TEST_CASE("the theorem does not apply to a mesh without triangles") {
  CHECK_FALSE(measure_theorem_hypotheses({}, 20).applies);
  CHECK_FALSE(measure_theorem_hypotheses({}, 0).applies);
}

namespace {

// A grid with one corner so far out that every site is near every other. No two metrics are equal.
mesh with_far_corner(int cells) {
  patch p = make_patch(cells, 0);
  site& corner = p.m.sites[p.at(0, 0)];
  corner.position.x -= 1000;
  corner.position.y -= 1000;
  for (std::size_t v = 0; v < p.m.sites.size(); ++v) {
    const double s = 1 + 1e-9 * static_cast<double>(v);
    p.m.sites[v].metric = {s, 0, s};
  }
  return p.m;
}

}  // namespace

// Comparing all pairs of a hundred thousand such sites takes hours. The work limit and an interrupt
// must end it.
TEST_CASE("measuring of pairs that are all near ended with no limit") {
  const mesh m = with_far_corner(50);
  const cancellation account = cancellation().with_work(1e9);
  const theorem_hypotheses h = measure_theorem_hypotheses(m, 0, account);
  CHECK(is_unmeasured(h));
  CHECK(h.reason == "not all was measured: the most work that is done for so many sites was done");
  CHECK(h.covering_radius == 0);
  const double spent = 1e9 - account.units_left();
  const auto sites = static_cast<double>(m.sites.size());
  CHECK(spent > 5e4);
  CHECK(spent < 1.1 * (1e5 + 20 * sites));
  CHECK_FALSE(is_unmeasured(measure_theorem_hypotheses(with_far_corner(20), 0)));
}

TEST_CASE("measuring ends as it is told to, and says nothing then but that") {
  const mesh m = with_far_corner(20);  // few enough sites for one thread
  int asked = 0;
  const cancellation stop = [&asked]() -> std::optional<std::string> {
    return ++asked > 3 ? std::optional<std::string>("enough") : std::nullopt;
  };
  const theorem_hypotheses h = measure_theorem_hypotheses(m, 0, stop);
  CHECK(is_unmeasured(h));
  CHECK(h.reason == "not all was measured: enough");
  CHECK(asked < 10);
}

TEST_CASE("a certificate may say that the theorem was not measured, and nothing more then") {
  const mesh m = make_patch(8, 0).m;
  audit_options options;
  options.angle_bound = 20;
  const audit_report report = audit(m, options);
  REQUIRE(report.certified);
  certificate claim = make_certificate(m, options, report);
  claim.complete = true;
  CHECK(verify(m, claim, {}).contradictions.empty());
  REQUIRE(claim.theorem);
  claim.theorem.emplace();
  claim.theorem->reason = "not all was measured: enough";
  CHECK(verify(m, claim, {}).contradictions.empty());
  claim.theorem->proved_angle = 30;
  CHECK(verify(m, claim, {}).contradictions.size() == 1);
  claim.theorem->proved_angle = 0;
  claim.theorem->applies = true;
  CHECK_FALSE(verify(m, claim, {}).contradictions.empty());
}

TEST_CASE("a variation or a spacing beyond the table proves no angle") {
  CHECK(theorem::proved_angle(0, 1) == 29.75);
  CHECK(theorem::proved_angle(0.052, 1) == 22.5);
  CHECK(theorem::proved_angle(0.0521, 1) == 21.75);
  CHECK(theorem::proved_angle(0.11, 1) == 0);
  CHECK(theorem::proved_angle(0.001, 1.71) == 0);
  CHECK(theorem::proved_angle(std::nan(""), 1) == 0);
}

TEST_CASE("the numbers of two sites are rounded to the side that is harder") {
  splitmix64 random(11);
  for (int k = 0; k < 20000; ++k) {
    const auto metric = [&] {
      const double a = std::exp(random.real(-6, 6)), b = std::exp(random.real(-6, 6));
      return metric_tensor{a, random.real(-0.999, 0.999) * std::sqrt(a * b), b};
    };
    const site p{{random.real(-1, 1), random.real(-1, 1)}, metric()};
    site q{{random.real(-1, 1), random.real(-1, 1)}, metric()};
    if (k % 2 == 0) q.metric = {p.metric.m11, p.metric.m12 * (1 + 1e-12), p.metric.m22};
    const theorem::pair_measures pair = theorem::measure_pair(p, q);
    const real from_p = distance(p, q.position), from_q = distance(q, p.position),
               tau = distortion(p.metric, q.metric);
    CHECK(pair.larger_distance_below <= std::max(from_p, from_q));
    CHECK(pair.larger_distance_below >= std::max(from_p, from_q) * (1 - 1e-10));
    CHECK(pair.distortion_above >= tau * (1 - 1e-18L));  // tau is rounded as well
    CHECK(pair.distortion_above <= tau * (1 + 1e-6));
    const double radius = random.real(0, 1);
    const real midway = std::max(from_p, from_q) / 2;
    if (midway <= radius) CHECK_FALSE(theorem::certainly_apart(p, q, radius));
  }
}

// A pair that is skipped must not exceed a measure. Nearly all pairs within the measures must be
// skipped.
TEST_CASE("two sites are within measures only if each of theirs is") {
  splitmix64 random(12);
  int within = 0, told = 0;
  for (int k = 0; k < 20000; ++k) {
    const double a = std::exp(random.real(-6, 6)), b = std::exp(random.real(-6, 6));
    const metric_tensor m{a, random.real(-0.999, 0.999) * std::sqrt(a * b), b};
    const double spread = std::exp2(random.real(-30, -1));
    const auto near = [&](double x) { return x * (1 + random.real(-spread, spread)); };
    const site p{{random.real(-1, 1), random.real(-1, 1)}, m};
    const site q{{random.real(-1, 1), random.real(-1, 1)}, {near(m.m11), m.m12, near(m.m22)}};
    if (!(q.metric.m11 * q.metric.m22 - q.metric.m12 * q.metric.m12 > 1e-3 * a * b)) continue;
    const real from_p = distance(p, q.position), from_q = distance(q, p.position),
               tau = distortion(p.metric, q.metric);
    const real sigma = (1 - 1 / tau) / std::min(from_p, from_q);
    const auto times = [&] { return random.real(-1, 1) < 0 ? 1 - 1e-9 : 1 + 1e-6; };
    const theorem::pair_measures known{static_cast<double>(std::max(from_p, from_q)) / times(),
                                       1 + static_cast<double>(tau - 1) * times(),
                                       static_cast<double>(sigma) * times()};
    const bool is = known.larger_distance_below <= std::max(from_p, from_q) &&
                    known.distortion_above >= tau && known.variation_above >= sigma;
    if (theorem::is_within(known, p, q)) {
      CHECK(is);
      ++told;
    }
    if (is && tau - 1 > 1e-3L) ++within;
  }
  CHECK(within > 500);
  CHECK(told > within / 2);
}

TEST_CASE("a site is certainly farther than the nearer end only if it is at every point") {
  splitmix64 random(12);
  int certain = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto metric = [&] {
      return metric_tensor{random.real(0.5, 2), random.real(-0.4, 0.4), random.real(0.5, 2)};
    };
    const site a{{0, 0}, metric()}, b{{1, 0}, metric()},
        w{{random.real(-1, 2), random.real(-1, 1)}, metric()};
    const bool farther = audit_detail::is_certainly_farther_than_nearer_end(a, b, w);
    real margin = std::numeric_limits<real>::infinity();
    for (int i = 0; i <= 256; ++i) {
      const point x{i / 256.0, 0};
      margin = std::min(margin, distance(w, x) - std::min(distance(a, x), distance(b, x)));
    }
    if (farther) CHECK(margin > 0);
    if (!farther) CHECK(margin < 0.02);
    certain += farther ? 1 : 0;
  }
  CHECK(certain > 2000);
}

TEST_CASE("both radii of a triangle cover it, and the quick one is seldom much larger") {
  splitmix64 random(31);
  int much_larger = 0;
  constexpr int triangles = 2000;
  for (int i = 0; i < triangles; ++i) {
    std::array<site, 3> t;
    const double scale = std::ldexp(1, static_cast<int>(random.real(-60, 60)));
    const point at{random.real(-1, 1) * scale * 1e3, random.real(-1, 1) * scale * 1e3};
    for (site& s : t) {
      const double a = random.real(0.5, 4), c = random.real(0.5, 4);
      const double b = random.real(-0.9, 0.9) * std::sqrt(a * c);
      s = {{at.x + random.real(-1, 1) * scale, at.y + random.real(-1, 1) * scale}, {a, b, c}};
    }
    const double radius = theorem::covering_radius_above(t),
                 quick = theorem::quick_covering_radius_above(t);
    INFO("triangle " << i << ", radii " << radius << " and " << quick);
    REQUIRE(quick > 0);
    if (quick > 1.5 * radius) ++much_larger;
    for (int k = 0; k < 30; ++k) {
      double u = random.real(), v = random.real();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const auto between = [&](double a, double b, double c) {
        return a + u * (b - a) + v * (c - a);
      };
      const point q{between(t[0].position.x, t[1].position.x, t[2].position.x),
                    between(t[0].position.y, t[1].position.y, t[2].position.y)};
      real nearest = std::numeric_limits<real>::infinity();
      for (const site& s : t) nearest = std::min(nearest, distance(s, q));
      REQUIRE(nearest <= radius * (1 + 1e-12L));
      REQUIRE(nearest <= quick * (1 + 1e-12L));
    }
  }
  CHECK(much_larger < triangles / 20);
}

TEST_CASE("a quick radius is not found where lengths leave the range of doubles") {
  const double far = 1e200;
  CHECK(std::isinf(theorem::quick_covering_radius_above(
      {site{{0, 0}, {far, 0, far}}, {{far, 0}, {far, 0, far}}, {{0, far}, {far, 0, far}}})));
}

// In this metric the triangle's extent along the first axis is rounding alone, as is that of the
// middle computed from it.
TEST_CASE("a quick radius knows how far the middle of a thin triangle is rounded") {
  splitmix64 random(32);
  const metric_tensor thin{0x1p120, 0, 1};
  for (int i = 0; i < 200; ++i) {
    const point b{random.real(0.3, 1), random.real(1, 2)},
        c{-random.real(0.3, 1), random.real(3, 4)};
    const std::array<site, 3> t = {site{{0, 0}, thin}, {b, thin}, {c, thin}};
    INFO("triangle " << i);
    // In this metric the three sites are nearly on a line. Half of the longest edge is the least
    // radius that covers them, up to a small part.
    const double half = 0x1p60 * (b.x - c.x) / 2;
    CHECK(theorem::quick_covering_radius_above(t) >= half);
  }
}
