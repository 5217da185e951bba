// SPDX-License-Identifier: MIT
//
// Meshes problems that are equal up to a scaling by powers of two, and problems that are affine
// images of one with a round metric.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/unit_frame.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

mesh_outcome mesh_of(const domain& d, const metric_field& field, bool limit_size) {
  mesh_options options;
  options.limit_size = limit_size;
  return testing::mesh_of(d, field, options);
}

domain scaled(domain d, double scale) {
  for (point& q : d.vertices) q = {scale * q.x, scale * q.y};
  return d;
}

// Returns the metric of the problem swirl:3 with length 1/4, scaled.
formula_field swirl_in(double scale) {
  return formula_field([scale](const point& q) {
    const metric_tensor m = swirl_field(3).at({q.x / scale, q.y / scale}).value();
    const auto in = [scale](double entry) { return 16 * entry / scale / scale; };
    return metric_tensor{in(m.m11), in(m.m12), in(m.m22)};
  });
}

// Maps [-1, 1]^2 by x = R diag(aspect, 1) R^T y, where R is a rotation. In the metric returned,
// lengths of images are those of the originals in units of `size`.
struct affine_image {
  domain shape;
  metric_tensor metric;
};
affine_image image_of_square(double aspect, double degrees, double size) {
  const double turn = degrees * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  domain d = square();
  for (point& q : d.vertices) {
    const double u = aspect * (c * q.x + s * q.y), v = -s * q.x + c * q.y;
    q = {c * u - s * v, s * u + c * v};
  }
  const double w = 1 / (aspect * aspect), n = 1 / (size * size);
  return {accepted(d), {n * (c * c * w + s * s), n * (c * s * (w - 1)), n * (s * s * w + c * c)}};
}

}  // namespace

TEST_CASE("scaled by powers of two, nothing changes but the scale, with a size as well") {
  // Products of tensor entries near 2^+-800 leave the range of doubles: search boxes become
  // infinite or empty, and each search visits all sites. Beyond 2^+-80 the filters decide nothing,
  // and exact arithmetic decides every predicate.
  const mesh_outcome plain = mesh_of(accepted(square()), swirl_in(1), true);
  for (const double scale : {0x1p90, 0x1p-200, 0x1p330, 0x1p400, 0x1p-400, 0x1p480, 0x1p-480}) {
    INFO("scale " << scale);
    const domain d = accepted(scaled(square(), scale));
    const mesh_outcome made = mesh_of(d, swirl_in(scale), true);
    check_certified(d, made, {});
    CHECK(made.result.triangles == plain.result.triangles);
    CHECK(made.ended.tolerance == plain.ended.tolerance);
    CHECK(std::equal(made.result.sites.begin(), made.result.sites.end(), plain.result.sites.begin(),
                     plain.result.sites.end(), [scale](const site& s, const site& p) {
                       return s.position.x == scale * p.position.x &&
                              s.position.y == scale * p.position.y;
                     }));
  }
}

TEST_CASE("without a size the metric need not be scaled back") {
  // The squares of these lengths overflow. Without scaling the insertion tolerance is infinite, and
  // no site can be inserted.
  const mesh_outcome plain = mesh_of(accepted(square()), swirl_in(1), false);
  const double ordinary = plain.ended.tolerance;
  for (const double scale : {0x1p-1000, 0x1p-300, 0x1p600, 0x1p1000}) {
    INFO("scale " << scale);
    const domain d = accepted(scaled(square(), scale));
    const formula_field field([scale](const point& q) {
      const metric_tensor m = swirl_in(1).at({q.x / scale, q.y / scale}).value();
      return metric_tensor{m.m11 / 16, m.m12 / 16, m.m22 / 16};
    });
    const mesh_outcome made = mesh_of(d, field, false);
    check_certified(d, made, {});
    CHECK(made.result.triangles == plain.result.triangles);
    CHECK(made.ended.tolerance == scale * ordinary / 4);
  }
}

TEST_CASE("a size as far beyond the domain as may be asked for is met by what is there") {
  // The determinants of these tensors underflow. Without scaling every angle counts as low, and
  // refinement gives up.
  for (const double size : {1e77, 1e100, 1e149}) {
    INFO("size " << size);
    const domain d = accepted(square());
    const double m = 1 / (size * size);
    const mesh_outcome made = mesh_of(d, constant_field({m, 0, m}), true);
    check_certified(d, made, {});
    CHECK(made.triangles == 2);
  }
}

TEST_CASE("the affine image of an isotropic problem has its quality") {
  // The squared length of a vector in the metric's long direction cancels. If it is computed from
  // the tensor's entries, nearly no Voronoi vertex is found at an aspect of 1e6, and hundreds of
  // triangles stay bad.
  constexpr double size = 0.2;
  const affine_image original = image_of_square(1, 0, size);
  const mesh_outcome plain = mesh_of(original.shape, constant_field(original.metric), true);
  const auto expected = static_cast<double>(plain.triangles);
  for (const double aspect : {1e2, 1e4, 1e6})
    for (int step = 0; step<12; step += aspect> 1e5 ? 1 : 3) {
      INFO("aspect " << aspect << ", turned by " << 7.5 * step << " degrees");
      const affine_image image = image_of_square(aspect, 7.5 * step, size);
      const mesh_outcome made = mesh_of(image.shape, constant_field(image.metric), true);
      check_certified(image.shape, made, {});
      const mesh_statistics measured = measure(made.result);
      CHECK(measured.below_20 == 0);
      CHECK(measured.unit_edges > 0.95);
      CHECK(static_cast<double>(made.triangles) == Approx(expected).epsilon(0.15));
      CHECK(measured.sigma < 1e-9);
    }
}

TEST_CASE("an aspect of 1e8, where a tensor's entries hardly tell its determinant") {
  for (const double degrees : {7.5, 30.0, 45.0}) {
    const affine_image image = image_of_square(1e8, degrees, 0.25);
    check_certified(image.shape, mesh_of(image.shape, constant_field(image.metric), true), {});
  }
}

TEST_CASE("a frame is exact or not taken") {
  const domain d = scaled(square(), 0x1p300);
  const formula_field field = swirl_in(0x1p300);
  const unit_frame frame = unit_frame::choose(d, field, false);
  CHECK_FALSE(frame.is_identity());
  const domain inside = frame.inward(d);
  for (std::size_t i = 0; i < d.vertices.size(); ++i) {
    CHECK(std::abs(inside.vertices[i].x) <= 2);
    CHECK(frame.outward(inside.vertices[i]) == d.vertices[i]);
  }
  CHECK(unit_frame::choose(square(), swirl_in(1), true).is_identity());
  // Scaling would underflow a vertex.
  domain mixed = d;
  mixed.vertices.push_back({0x1p-1000, 0});
  CHECK(unit_frame::choose(mixed, field, false).is_identity());
  // Scaling would overflow a metric.
  CHECK(unit_frame::choose(d, constant_field({0x1p500, 0, 1}), false).is_identity());
}

TEST_CASE("a metric that leaves the range of doubles in a frame is named") {
  const domain d = accepted(scaled(square(), 0x1p300));
  const formula_field field([](const point& q) {
    const double one = 0x1p-596, hot = std::abs(q.x) + std::abs(q.y) < 0x1p299 ? 0x1p500 : one;
    return metric_tensor{hot, 0, one};
  });
  mesh_options options;
  options.limit_size = true;
  const auto made = make_mesh(d, field, options);
  REQUIRE_FALSE(made.ok());
  CHECK(made.failure().message.find("lengths in it leave the range") != std::string::npos);
}
