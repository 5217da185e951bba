// SPDX-License-Identifier: MIT
//
// Meshes in one metric for all sites, where stars cannot agree in the given metric and no delivered
// metric led to a mesh. They have no disagreeing triangles, their metric says how it differs from
// the one given, and their low angles are named.
#include "asterism/mesh/delivery/constant_metric_fallback.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

// Makes the mesh as make_mesh does, without the attempt that delivers a metric.
mesh_outcome mesh_at_last_of(const domain& d, const metric_field& field,
                             const mesh_options& options) {
  using namespace asterism::internal;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const normalised_problem image(d, field, options);
  auto made = mesh_domain({stars_on, image.shape(), image.field(), options});
  REQUIRE(made.ok());
  image.outward(made.value());
  if (wants_other_metric(made.value(), options) && options.metric_tolerance != 0.0)
    made = refine_in_one_metric({stars_on, d, field, options}, std::move(made).value());
  REQUIRE(made.ok());
  assign_regions(made.value().result, d);
  return std::move(made).value();
}

// Makes the mesh in the metric wanted, and in no other.
void mesh_before_last_of(const domain& d, const metric_field& field, const mesh_options& options) {
  using namespace asterism::internal;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const normalised_problem image(d, field, options);
  REQUIRE(mesh_domain({stars_on, image.shape(), image.field(), options}).ok());
}

mesh_options with_size() {
  mesh_options options;
  options.limit_size = true;
  return options;
}

// Squares of `side`, stretched ten times, alternately along x and along y.
formula_field checkerboard(double side, double size) {
  return formula_field([side, size](const point& q) {
    const bool along = (std::lround(std::floor(q.x / side) + std::floor(q.y / side)) & 1) != 0;
    const double s = 1 / (size * size);
    return along ? metric_tensor{100 * s, 0, s} : metric_tensor{s, 0, 100 * s};
  });
}

formula_field swirl(double k, double size) {
  return formula_field([k, size](const point& q) {
    const double s = 1 / (size * size);
    return metric_tensor{s * (1 + k * q.x * q.x), s * k * q.x * q.y, s * (1 + k * q.y * q.y)};
  });
}

// Returns one mesh that several tests share.
const mesh_outcome& checkered() {
  static const mesh_outcome made =
      mesh_at_last_of(accepted(square()), checkerboard(0.52, 0.8), with_size());
  return made;
}

// Checks that the mesh of the whole domain is certified in its own metric, with angles and stars.
void check_conforming(const domain& d, const mesh_outcome& made, double angle_bound) {
  INFO(ending_text(made));
  CHECK(made.disagreeing == 0);
  CHECK(made.result.disagreeing.empty());
  audit_options options;
  options.angle_bound = angle_bound;
  options.find_exempt_corners = true;
  options.original = &d;
  const audit_report report = audit(made.result, options);
  for (const audit_finding& f : report.findings) UNSCOPED_INFO(f.witness);
  CHECK(report.certified);
  REQUIRE(made.one_metric);
  REQUIRE(made.delivered);
  CHECK(made.complete == made.one_metric->has_demands);
  for (const site& s : made.result.sites) CHECK(identical(s.metric, made.result.sites[0].metric));
}

double least_angle(const mesh& m, const std::vector<metric_tensor>& tensors, const triangle& t) {
  double least = 180;
  for (const vertex_index perspective : t)
    for (std::size_t i = 0; i < 3; ++i) {
      const point &o = m.sites[t[i]].position, &p = m.sites[t[(i + 1) % 3]].position,
                  &q = m.sites[t[(i + 2) % 3]].position;
      const metric_tensor& M = tensors[perspective];
      const point a{p.x - o.x, p.y - o.y}, b{q.x - o.x, q.y - o.y};
      const double along = a.x * (M.m11 * b.x + M.m12 * b.y) + a.y * (M.m12 * b.x + M.m22 * b.y);
      const double across = std::sqrt(M.m11 * M.m22 - M.m12 * M.m12) * (a.x * b.y - a.y * b.x);
      least = std::min(least, std::atan2(across, along) * 180 / std::numbers::pi);
    }
  return least;
}

// Compares the auditor's list with angles measured here. No corner of the domain may be sharp.
void check_named(const mesh_outcome& made, const metric_field& field, double angle_bound) {
  const delivered_report& delivered = made.delivered.value();
  std::vector<metric_tensor> wanted;
  for (const site& s : made.result.sites) wanted.push_back(field.at(s.position).value());
  double worst = 180;
  std::vector<vertex_index> low;
  for (vertex_index t = 0; t < made.triangles; ++t) {
    const double angle = least_angle(made.result, wanted, made.result.triangles[t]);
    worst = std::min(worst, angle);
    if (angle < angle_bound) low.push_back(t);
  }
  CHECK(delivered.low_wanted == low);
  CHECK(delivered.worst_angle_wanted == Approx(worst));
}

}  // namespace

TEST_CASE("last resort: perpendicular stretchings side by side, with a size and without") {
  const domain d = accepted(square());
  for (const bool limit_size : {true, false}) {
    mesh_options options;
    options.limit_size = limit_size;
    const formula_field field = checkerboard(0.52, 0.8);
    const mesh_outcome made = limit_size ? checkered() : mesh_at_last_of(d, field, options);
    check_conforming(d, made, 20);
    check_named(made, field, 20);
    CHECK(made.complete);
    CHECK_FALSE(made.delivered->low_wanted.empty());
    CHECK(made.one_metric->has_demands);
    CHECK(made.delivered->changed == made.sites);
    CHECK(made.delivered->greatest > std::log(2));
    CHECK(ending_text(made.one_metric->as_given).find("the metric varies faster than sites") !=
          std::string::npos);
    CHECK(ending_text(made).find("stars cannot agree in the metric given") == 0);
  }
}

TEST_CASE("last resort: a jump of the size alone is complete in one metric for all") {
  for (const double jump : {10.0, 1e4}) {
    const formula_field field([jump](const point& q) {
      const double s = q.x < 0.13 ? 100 : 100 / (jump * jump);
      return metric_tensor{s, 0, s};
    });
    const domain d = accepted(square());
    const mesh_outcome made = mesh_at_last_of(d, field, with_size());
    check_conforming(d, made, 20);
    check_named(made, field, 20);
    CHECK(made.complete);
    CHECK(made.delivered->low_wanted.empty());
  }
}

TEST_CASE("last resort: a metric too wild to follow at all becomes one metric for all") {
  const domain d = accepted(square());
  const mesh_outcome made = mesh_at_last_of(d, swirl(1e8, 10), with_size());
  check_conforming(d, made, 20);
  CHECK(made.one_metric->has_demands);
  CHECK(made.sites > 100);
  CHECK(ending_text(made.one_metric->as_given)
            .find("the metric varies too fast for sites to be spread: of ") == 0);
}

TEST_CASE("last resort: not where it is not wanted, and not for the thesis's heuristics") {
  const domain d = accepted(square());
  mesh_options options = with_size();
  options.metric_tolerance = 0;
  const mesh_outcome kept = mesh_at_last_of(d, checkerboard(0.52, 0.8), options);
  CHECK_FALSE(kept.complete);
  CHECK(kept.disagreeing > 0);
  CHECK_FALSE(kept.one_metric);
  options.metric_tolerance.reset();
  options.max_sites = 60;
  for (const auto strategy :
       {refinement_strategy::voronoi_arcs, refinement_strategy::poisson_darts}) {
    options.strategy = strategy;
    const mesh_outcome made = mesh_at_last_of(d, checkerboard(0.52, 0.8), options);
    CHECK_FALSE(made.complete);
    CHECK_FALSE(made.one_metric);
  }
}

TEST_CASE("last resort: agreement within a small limit on sites") {
  const domain d = accepted(square());
  for (const std::size_t most : {8, 20, 60, 200}) {
    mesh_options options;
    options.max_sites = most;
    const mesh_outcome made = mesh_at_last_of(d, swirl(400, 1), options);
    INFO(most << ": " << ending_text(made));
    CHECK(made.sites <= most);
    CHECK(made.disagreeing == 0);
    audit_options wanted;
    wanted.original = &d;
    CHECK(audit(made.result, wanted).certified);
  }
}

TEST_CASE("last resort: a field that says nothing outside the domain") {
  const domain d = accepted(polygon({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}));
  const formula_field jump = checkerboard(0.52, 0.8);
  class undefined_outside : public metric_field {
   public:
    explicit undefined_outside(const metric_field& inside) : inside_(&inside) {}
    result<metric_tensor> at(const point& q) const override {
      if (q.x > 0x1p-40 && q.y > 0x1p-40) return error{"outside"};
      return inside_->at(q);
    }

   private:
    const metric_field* inside_;
  };
  const undefined_outside field(jump);
  const mesh_outcome made = mesh_at_last_of(d, field, with_size());
  check_conforming(d, made, 20);
}

TEST_CASE("last resort: the same for any number of threads and at any scale") {
  const domain d = accepted(square());
  const mesh_outcome& first = checkered();
  {
    const internal::thread_limit one(1);
    const mesh_outcome again = mesh_at_last_of(d, checkerboard(0.52, 0.8), with_size());
    CHECK(mesh_fingerprint(again.result) == mesh_fingerprint(first.result));
    CHECK(ending_text(again) == ending_text(first));
    CHECK(again.delivered->low_wanted == first.delivered->low_wanted);
  }
  for (const int exponent : {-400, 400}) {
    domain scaled = d;
    for (point& q : scaled.vertices) q = {std::ldexp(q.x, exponent), std::ldexp(q.y, exponent)};
    const formula_field field([exponent](const point& q) {
      const auto m = checkerboard(0.52, 0.8)
                         .at({std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)})
                         .value();
      return metric_tensor{std::ldexp(m.m11, -2 * exponent), std::ldexp(m.m12, -2 * exponent),
                           std::ldexp(m.m22, -2 * exponent)};
    });
    const mesh_outcome made = mesh_at_last_of(accepted(scaled), field, with_size());
    INFO(exponent << ": " << ending_text(made));
    // Scaling changes the rounding of logarithms.
    CHECK(made.one_metric->has_demands == first.one_metric->has_demands);
    CHECK(static_cast<double>(made.triangles) == Approx(first.triangles).epsilon(0.1));
    CHECK(made.disagreeing == 0);
    CHECK(made.delivered->greatest == Approx(first.delivered->greatest).epsilon(0.1));
  }
}

TEST_CASE("last resort: a stop is kept to in one metric for all") {
  const domain d = accepted(square());
  std::size_t asked = 0;
  mesh_options options = with_size();
  options.stop = [&asked]() -> std::optional<std::string> {
    ++asked;
    return std::nullopt;
  };
  mesh_before_last_of(d, checkerboard(0.52, 0.8), options);
  const std::size_t without = asked;
  asked = 0;
  options.stop = [&]() -> std::optional<std::string> {
    if (++asked <= without) return std::nullopt;
    return "enough";
  };
  const mesh_outcome made = mesh_at_last_of(d, checkerboard(0.52, 0.8), options);
  INFO(ending_text(made));
  CHECK(made.stopped);
  CHECK_FALSE(made.complete);
  CHECK_FALSE(made.one_metric);
  CHECK(ending_text(made).find("in one metric for all") != std::string::npos);
}

TEST_CASE("last resort: the field was asked for a minute after the run was stopped") {
  const domain d = accepted(square());
  std::atomic<std::size_t> evaluations = 0;
  const formula_field field([&evaluations](const point& q) {
    ++evaluations;
    return checkerboard(0.52, 0.8).at(q).value();
  });
  std::size_t asked = 0, most = SIZE_MAX, at_stop = 0;
  mesh_options options = with_size();
  options.stop = [&]() -> std::optional<std::string> {
    if (++asked <= most) return std::nullopt;
    if (at_stop == 0) at_stop = evaluations;
    return "enough";
  };
  mesh_before_last_of(d, field, options);
  most = asked + 1;
  asked = 0;
  const mesh_outcome made = mesh_at_last_of(d, field, options);
  INFO(ending_text(made));
  CHECK(made.stopped);
  CHECK(ending_text(made).find("stopped: enough, in one metric for all; before that") == 0);
  CHECK(evaluations - at_stop == 0);
}

TEST_CASE("last resort: certificates say how far the metric is, and are read back") {
  const mesh_outcome& made = checkered();
  audit_options options;
  options.angle_bound = 20;
  certificate claim = make_certificate(made.result, options, audit(made.result, options));
  claim.delivered = made.delivered;
  const std::string text = certificate_text(claim);
  const auto read = parse_certificate(text, "test");
  REQUIRE(read.ok());
  REQUIRE(read.value().delivered.has_value());
  CHECK(read.value().delivered->low_wanted == made.delivered->low_wanted);
  CHECK(certificate_text(read.value()) == text);
  const auto field = checkerboard(0.52, 0.8);
  using asterism::internal::contradictions_in_delivered;
  CHECK(contradictions_in_delivered(made.result, claim, field).empty());
  claim.delivered->low_wanted.pop_back();
  CHECK(contradictions_in_delivered(made.result, claim, field).size() == 1);
}

TEST_CASE("certificates of earlier versions are read where nothing was relaxed") {
  const mesh_outcome& made = checkered();
  audit_options options;
  options.angle_bound = 20;
  const certificate claim = make_certificate(made.result, options, audit(made.result, options));
  const std::string text = certificate_text(claim);
  const auto with_relaxed = [&text](const std::string& what) {
    const std::string after = "\"delivered\"";
    std::string older = text;
    return older.insert(older.find(after), "\"relaxed\": " + what + ", ");
  };
  const auto older = parse_certificate(with_relaxed("null"), "test");
  REQUIRE(older.ok());
  CHECK(certificate_text(older.value()) == text);
  const auto refused = parse_certificate(with_relaxed("{}"), "test");
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.failure().message.find("an earlier version relaxed all over") != std::string::npos);
}
