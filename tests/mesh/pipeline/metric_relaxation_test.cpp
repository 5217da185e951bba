// SPDX-License-Identifier: MIT
//
// Metrics in which stars cannot agree, where a metric delivered did not lead to a mesh: what comes
// out is a mesh without disagreeing triangles, of a metric that says how it differs from the one
// given, and what is low in that is named.
#include "asterism/mesh/pipeline/metric_relaxation.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

// Makes the mesh as make_mesh does, but for the metric delivered.
mesh_outcome relaxed_mesh_of(const domain& d, const metric_field& field,
                             const mesh_options& options) {
  using namespace asterism::internal;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const unit_image image(d, field, options);
  auto made = mesh_domain({stars_on, image.shape(), image.field(), options});
  REQUIRE(made.ok());
  image.outward(made.value());
  if (wants_relaxation(made.value(), options))
    made = refine_relaxed({stars_on, d, field, options}, std::move(made).value());
  REQUIRE(made.ok());
  assign_regions(made.value().result, d);
  return std::move(made).value();
}

mesh_options with_size() {
  mesh_options options;
  options.limit_size = true;
  return options;
}

// Squares of `side` stretched ten times, in turns along x and along y.
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

// One mesh for many questions.
const mesh_outcome& checkered() {
  static const mesh_outcome made =
      relaxed_mesh_of(accepted(square()), checkerboard(0.52, 0.8), with_size());
  return made;
}

// Certified in its own metric, angles and stars, and of the whole domain.
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
  REQUIRE(made.relaxed);
  CHECK(made.relaxed->given.size() == made.sites);
  CHECK(made.complete == made.relaxed->low_triangles.empty());
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

// The auditor's list against angles measured here; no corner of the domain may be sharp.
void check_named(const mesh_outcome& made, double angle_bound) {
  const relaxation_report& relaxed = made.relaxed.value();
  double worst = 180;
  std::vector<vertex_index> low;
  for (vertex_index t = 0; t < made.triangles; ++t) {
    const double angle = least_angle(made.result, relaxed.given, made.result.triangles[t]);
    worst = std::min(worst, angle);
    if (angle < angle_bound) low.push_back(t);
  }
  CHECK(relaxed.low_triangles == low);
  CHECK(relaxed.worst_angle == Approx(worst));
}

}  // namespace

TEST_CASE("relaxation: perpendicular stretchings side by side, with a size and without") {
  const domain d = accepted(square());
  for (const bool limit_size : {true, false}) {
    mesh_options options;
    options.limit_size = limit_size;
    const formula_field field = checkerboard(0.52, 0.8);
    const mesh_outcome made = limit_size ? checkered() : relaxed_mesh_of(d, field, options);
    check_conforming(d, made, 20);
    check_named(made, 20);
    CHECK_FALSE(made.complete);
    CHECK_FALSE(made.relaxed->low_triangles.empty());
    CHECK(made.relaxed->kind == relaxation_kind::constant);
    CHECK(made.relaxed->changed > 0);
    CHECK(made.relaxed->most_longer > 2);
    CHECK(made.relaxed->why.find("the metric varies faster than sites") != std::string::npos);
    CHECK(ending_text(made).find("stars cannot agree in the metric given") == 0);
  }
}

TEST_CASE("relaxation: a jump of the size alone is complete in one metric for all") {
  for (const double jump : {10.0, 1e4}) {
    const formula_field field([jump](const point& q) {
      const double s = q.x < 0.13 ? 100 : 100 / (jump * jump);
      return metric_tensor{s, 0, s};
    });
    const domain d = accepted(square());
    const mesh_outcome made = relaxed_mesh_of(d, field, with_size());
    check_conforming(d, made, 20);
    check_named(made, 20);
    CHECK(made.complete);
    CHECK(made.relaxed->kind == relaxation_kind::constant);
  }
}

TEST_CASE("relaxation: a metric too wild to follow at all becomes one metric for all") {
  const domain d = accepted(square());
  const mesh_outcome made = relaxed_mesh_of(d, swirl(1e8, 10), with_size());
  check_conforming(d, made, 20);
  CHECK(made.relaxed->kind == relaxation_kind::constant);
  CHECK(made.sites > 100);
  CHECK(made.relaxed->why.find("the metric varies too fast for sites to be spread: of ") == 0);
}

TEST_CASE("relaxation: not where it is not wanted, and not for the thesis's heuristics") {
  const domain d = accepted(square());
  mesh_options options = with_size();
  options.relax = false;
  const mesh_outcome kept = relaxed_mesh_of(d, checkerboard(0.52, 0.8), options);
  CHECK_FALSE(kept.complete);
  CHECK(kept.disagreeing > 0);
  CHECK_FALSE(kept.relaxed.has_value());
  options.relax = true;
  options.max_sites = 60;
  for (const auto strategy :
       {refinement_strategy::voronoi_arcs, refinement_strategy::poisson_darts}) {
    options.strategy = strategy;
    const mesh_outcome made = relaxed_mesh_of(d, checkerboard(0.52, 0.8), options);
    CHECK_FALSE(made.complete);
    CHECK_FALSE(made.relaxed.has_value());
  }
}

TEST_CASE("relaxation: agreement within a small limit on sites") {
  const domain d = accepted(square());
  for (const std::size_t most : {8, 20, 60, 200}) {
    mesh_options options;
    options.max_sites = most;
    const mesh_outcome made = relaxed_mesh_of(d, swirl(400, 1), options);
    INFO(most << ": " << ending_text(made));
    CHECK(made.sites <= most);
    CHECK(made.disagreeing == 0);
    audit_options wanted;
    wanted.original = &d;
    CHECK(audit(made.result, wanted).certified);
  }
}

TEST_CASE("relaxation: a field that says nothing outside the domain") {
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
  const mesh_outcome made = relaxed_mesh_of(d, field, with_size());
  check_conforming(d, made, 20);
}

TEST_CASE("relaxation: the same for any number of threads and at any scale") {
  const domain d = accepted(square());
  const mesh_outcome& first = checkered();
  {
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const mesh_outcome again = relaxed_mesh_of(d, checkerboard(0.52, 0.8), with_size());
    CHECK(mesh_fingerprint(again.result) == mesh_fingerprint(first.result));
    CHECK(ending_text(again) == ending_text(first));
    CHECK(again.relaxed->low_triangles == first.relaxed->low_triangles);
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
    const mesh_outcome made = relaxed_mesh_of(accepted(scaled), field, with_size());
    INFO(exponent << ": " << ending_text(made));
    // Logarithms are rounded otherwise there.
    CHECK(made.relaxed->kind == first.relaxed->kind);
    CHECK(static_cast<double>(made.triangles) == Approx(first.triangles).epsilon(0.1));
    CHECK(made.disagreeing == 0);
    CHECK(made.relaxed->most_longer == Approx(first.relaxed->most_longer).epsilon(0.1));
  }
}

TEST_CASE("relaxation: a stop is kept to while the metric is relaxed") {
  const domain d = accepted(square());
  std::size_t asked = 0;
  mesh_options options = with_size();
  options.relax = false;
  options.stop = [&asked]() -> std::optional<std::string> {
    ++asked;
    return std::nullopt;
  };
  relaxed_mesh_of(d, checkerboard(0.52, 0.8), options);
  const std::size_t without = asked;
  asked = 0;
  options.relax = true;
  options.stop = [&]() -> std::optional<std::string> {
    if (++asked <= without) return std::nullopt;
    return "enough";
  };
  const mesh_outcome made = relaxed_mesh_of(d, checkerboard(0.52, 0.8), options);
  INFO(ending_text(made));
  CHECK(made.stopped);
  CHECK_FALSE(made.complete);
  CHECK_FALSE(made.relaxed.has_value());
  CHECK(ending_text(made).find("in the metric relaxed") != std::string::npos);
}

TEST_CASE("relaxation: the field was asked for a minute after the run was stopped") {
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
  options.relax = false;
  relaxed_mesh_of(d, field, options);
  most = asked + 1;
  asked = 0;
  options.relax = true;
  const mesh_outcome made = relaxed_mesh_of(d, field, options);
  INFO(ending_text(made));
  CHECK(made.stopped);
  CHECK(ending_text(made).find("stopped: enough, in the metric relaxed; before that") == 0);
  CHECK(evaluations - at_stop == 0);
}

TEST_CASE("relaxation: certificates say of which metric a mesh is, and are read back") {
  const mesh_outcome& made = checkered();
  audit_options options;
  options.angle_bound = 20;
  certificate claim = make_certificate(made.result, options, audit(made.result, options));
  claim.relaxed = made.relaxed;
  const std::string text = certificate_text(claim);
  const auto read = parse_certificate(text, "test");
  REQUIRE(read.ok());
  REQUIRE(read.value().relaxed.has_value());
  CHECK(read.value().relaxed->kind == made.relaxed->kind);
  CHECK(read.value().relaxed->low_triangles == made.relaxed->low_triangles);
  CHECK(certificate_text(read.value()) == text);
  const auto field = checkerboard(0.52, 0.8);
  CHECK_FALSE(contradiction_in_low_triangles(made.result, claim, field).has_value());
  claim.complete = true;
  const verify_report verdict = verify(made.result, claim, {});
  CHECK_FALSE(verdict.verified);
  REQUIRE(verdict.contradictions.size() == 1);
  CHECK(verdict.contradictions[0].find("was completed, and lists") != std::string::npos);
  const vertex_index left_out = claim.relaxed->low_triangles.back();
  claim.relaxed->low_triangles.pop_back();
  const auto said = contradiction_in_low_triangles(made.result, claim, field);
  REQUIRE(said.has_value());
  CHECK(said->find("; triangle " + std::to_string(left_out + 1) + " is the first") !=
        std::string::npos);
  std::string spoiled = text;
  spoiled.replace(spoiled.find("\"constant\""), 10, "\"guessed\"");
  CHECK(parse_certificate(spoiled, "test").failure().message.find("guessed") != std::string::npos);
}
