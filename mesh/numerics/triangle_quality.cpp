// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/triangle_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "asterism/core/elementary.hpp"
#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/vertex_hints.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/support/double_double.hpp"

namespace asterism::internal {
namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

point difference(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }
double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }

// Returns the sum of the magnitudes of inner_product's terms. Each term takes three rounded
// products and two rounded differences of coordinates: 8 epsilon of this sum exceeds the
// error.
double inner_product_magnitude(const metric_tensor& m, const point& a, const point& b) {
  return m.m11 * std::abs(a.x * b.x) +
         std::abs(m.m12) * (std::abs(a.x * b.y) + std::abs(a.y * b.x)) +
         m.m22 * std::abs(a.y * b.y);
}

// Returns the tensor times a power of two, so that its determinant stays in the range of doubles:
// an angle does not depend on units. That is exact unless the tensor is wider than any usual
// aspect.
metric_tensor in_range(const metric_tensor& m) {
  const double product = m.m11 * m.m22;
  if (0x1p-900 < product && product < 0x1p900) return m;
  const int exponent = -(std::ilogb(m.m11) + std::ilogb(m.m22)) / 2;
  return {std::scalbn(m.m11, exponent), std::scalbn(m.m12, exponent), std::scalbn(m.m22, exponent)};
}

// A metric scaled into range, and the root of a lower bound on its determinant; 0 where doubles
// prove none.
struct measuring_metric {
  explicit measuring_metric(const metric_tensor& given) : m(in_range(given)) {
    const double product = m.m11 * m.m22, square = m.m12 * m.m12;
    const double det = product - square - 4 * epsilon * (product + square);
    if (det > 0) root = std::sqrt(det);
  }

  metric_tensor m;
  double root = 0;
};

// The two sides at a corner, and a lower bound on the area that they span.
struct corner_sides {
  corner_sides(const point& first, const point& second)
      : a(first),
        b(second),
        area(cross(a, b) - 8 * epsilon * (std::abs(a.x * b.y) + std::abs(a.y * b.x))) {}

  point a, b;
  double area;
};

bool corner_is_low(const measuring_metric& by, const corner_sides& c, double cotangent) {
  const double left =
      inner_product(by.m, c.a, c.b) + 8 * epsilon * inner_product_magnitude(by.m, c.a, c.b);
  if (left <= 0) return false;
  if (!(by.root > 0) || !(c.area > 0)) return true;  // too thin to be sure of in doubles
  return !(left <= cotangent * by.root * c.area * (1 - 4 * epsilon));
}

// Tests a corner in a thin metric, in twice the precision. Differences of doubles are exact there;
// the rest are sums of at most 16 operations, each off by less than 2^-102 of its result, so that
// 2^-97 of the magnitudes covers them. Rounding to doubles is relative, and within the 4 epsilon.
bool thin_corner_is_low(const metric_tensor& given, const std::array<point, 3>& corner,
                        double cotangent) {
  const metric_tensor m = in_range(given);
  using wide = double_double;
  const auto& [o, p, q] = corner;
  const wide ax = wide(p.x) - o.x, ay = wide(p.y) - o.y, bx = wide(q.x) - o.x, by = wide(q.y) - o.y;
  const point a{ax.high, ay.high}, b{bx.high, by.high};
  constexpr double part = 0x1p-97;
  const double inner =
      static_cast<double>(wide(m.m11) * (ax * bx) + wide(m.m12) * (ax * by + ay * bx) +
                          wide(m.m22) * (ay * by)) +
      part * inner_product_magnitude(m, a, b);
  if (inner <= 0) return false;
  const double det =
      static_cast<double>(wide(m.m11) * m.m22 - wide(m.m12) * m.m12) - part * m.m11 * m.m22;
  const double area =
      static_cast<double>(ax * by - ay * bx) - part * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
  if (!(det > 0) || !(area > 0)) return true;
  return !(inner <= cotangent * std::sqrt(det) * area * (1 - 8 * epsilon));
}

// True if all nine angles are certainly above the angle with this cotangent, which must be from 0.1
// to 60 degrees. Returns false for thin metrics and for angles near the threshold, which other
// tests decide.
//
// Errors. A metric that is not thin has a determinant of 2^-14 of its monomials or more, so that no
// monomial of the inner product of two sides is more than 2^15 times N, the product of their
// lengths, and none of their area, times the root of the determinant, more than 2^8 N. So the inner
// product is off by less than 2^-32 N, and that area, with the root, by less than 2^-36 N. An angle
// theta <= b could pass by these errors only with
//   cos theta - 2^-32 < cot b (1 - 2^-24) (sin theta + 2^-36), hence only with
//   sin (b - theta) + 2^-24 sin theta cos b < 2^-32 sin b + 2^-36.
// The left side is least at theta = b, where it is more from 0.1 degrees on.
bool all_angles_are_above(const triangle_sites& t, double cotangent) {
  constexpr double nearly = 1 - 0x1p-24, of_sixty_degrees = 0.577, of_tenth_degree = 572;
  if (!(cotangent > of_sixty_degrees && cotangent < of_tenth_degree)) return false;
  const double most = cotangent * nearly, squared = most * most;
  const bool is_one = identical(t[0].metric, t[1].metric) && identical(t[0].metric, t[2].metric);
  const std::size_t metrics = is_one ? 1 : 3;
  std::array<double, 3> bounds{};
  for (std::size_t j = 0; j < metrics; ++j) {
    const metric_tensor& m = t[j].metric;
    if (is_thin(m)) return false;
    bounds[j] = squared * (m.m11 * m.m22 - m.m12 * m.m12);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const point a = difference(t[(i + 1) % 3].position, t[i].position),
                b = difference(t[(i + 2) % 3].position, t[i].position);
    const double area = cross(a, b);
    if (!(area > 0)) return false;
    for (std::size_t j = 0; j < metrics; ++j) {
      const double along = inner_product(t[j].metric, a, b);
      if (!(along <= 0 || along * along < bounds[j] * (area * area))) return false;
    }
  }
  return true;
}

// An angle as its sine and its cosine, both times one positive number.
struct angle_sides {
  double across = 0, along = 0;

  double degrees() const { return elementary::atan2(across, along) * to_degrees; }
};

angle_sides sides_of_angle(double root_of_determinant, const metric_tensor& m, const point& a,
                           const point& b) {
  return {root_of_determinant * cross(a, b), inner_product(m, a, b)};
}

double angle_between(const metric_tensor& m, const point& a, const point& b) {
  return sides_of_angle(root_of_determinant(m), m, a, b).degrees();
}

}  // namespace

angle_requirement::angle_requirement(double degrees)
    : degrees_(degrees), cotangent_(1 / elementary::tan(degrees * (1 + 1e-9) / to_degrees)) {}

bool angle_requirement::is_low(const triangle_sites& t, const angle_set& left_out) const {
  if (degrees_ == 0 || all_angles_are_above(t, cotangent_)) return false;
  const std::array<measuring_metric, 3> by = {
      measuring_metric(t[0].metric), measuring_metric(t[1].metric), measuring_metric(t[2].metric)};
  for (std::size_t i = 0; i < 3; ++i) {
    const corner_sides sides(difference(t[(i + 1) % 3].position, t[i].position),
                             difference(t[(i + 2) % 3].position, t[i].position));
    for (std::size_t j = 0; j < 3; ++j) {
      const metric_tensor& m = t[j].metric;
      if (!left_out.which[i][j] && corner_is_low(by[j], sides, cotangent_) &&
          !(is_thin(m) &&
            !thin_corner_is_low(
                m, {t[i].position, t[(i + 1) % 3].position, t[(i + 2) % 3].position}, cotangent_)))
        return true;
    }
  }
  return false;
}

triangle_sites in_round_coordinates(triangle_sites t) {
  const auto thin =
      std::find_if(t.begin(), t.end(), [](const site& s) { return is_thin(s.metric); });
  if (thin == t.end()) return t;
  const round_coordinates round(t[0].position, thin->metric);
  for (site& s : t) s = round.inward(s);
  return t;
}

namespace {

// Measures the angles of a triangle in its metrics; three equal metrics are measured once.
struct measured_angles {
  explicit measured_angles(const triangle_sites& t) {
    const bool is_one = identical(t[0].metric, t[1].metric) && identical(t[0].metric, t[2].metric);
    const std::size_t metrics = is_one ? 1 : 3;
    count = 3 * metrics;
    std::array<double, 3> roots{};
    for (std::size_t i = 0; i < metrics; ++i) roots[i] = root_of_determinant(t[i].metric);
    for (std::size_t i = 0; i < 3; ++i) {
      const point a = difference(t[(i + 1) % 3].position, t[i].position);
      const point b = difference(t[(i + 2) % 3].position, t[i].position);
      for (std::size_t j = 0; j < metrics; ++j) {
        const std::size_t k = metrics * i + j;
        angles[k] = sides_of_angle(roots[j], t[j].metric, a, b);
        cotangents[k] = angles[k].along / angles[k].across;
        if (angles[k].across > 0)
          greatest = std::max(greatest, cotangents[k]);
        else
          all_turn = false;
      }
    }
  }

  std::size_t count = 0;
  std::array<angle_sides, 9> angles;
  std::array<double, 9> cotangents{};
  double greatest = -std::numeric_limits<double>::infinity();
  bool all_turn = true;  // no angle is flat or turned over
};

// Returns measured_angles::greatest for three equal metrics; none where they differ, or an angle is
// flat or turned over.
std::optional<double> greatest_cotangent_in_one_metric(const triangle_sites& t) {
  const metric_tensor& m = t[0].metric;
  if (!identical(m, t[1].metric) || !identical(m, t[2].metric)) return std::nullopt;
  const double root = root_of_determinant(m);
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const angle_sides angle =
        sides_of_angle(root, m, difference(t[(i + 1) % 3].position, t[i].position),
                       difference(t[(i + 2) % 3].position, t[i].position));
    if (!(angle.across > 0)) return std::nullopt;
    greatest = std::max(greatest, angle.along / angle.across);
  }
  return greatest;
}

// Computes the arctangent only of cotangents within a few roundings of the greatest one.
double smallest_of(const measured_angles& m) {
  const double nearly = m.greatest - 0x1p-40 * (1 + std::abs(m.greatest));
  double smallest = 180;
  for (std::size_t k = 0; k < m.count; ++k) {
    const bool is_greater = m.angles[k].across > 0 && m.cotangents[k] < nearly;
    if (!is_greater) smallest = std::min(smallest, m.angles[k].degrees());
  }
  return smallest;
}

}  // namespace

double smallest_angle(const triangle_sites& given) {
  return smallest_of(measured_angles(in_round_coordinates(given)));
}

angle_threshold::angle_threshold(double wanted)
    : degrees(wanted), cotangent(1 / elementary::tan(wanted / to_degrees)) {}

// Returns for each threshold whether the smallest angle is below it. Computes the angle itself
// where roundings of the angle and of its cotangent could give different answers.
std::array<bool, 2> smallest_angle_is_below(const triangle_sites& t,
                                            const std::array<angle_threshold, 2>& thresholds) {
  if (all_angles_are_above(t, std::min(thresholds[0].cotangent, thresholds[1].cotangent)))
    return {};
  constexpr double margin = 1e-9;
  const auto is_near = [&](double greatest, const angle_threshold& threshold) {
    return !(std::abs(greatest - threshold.cotangent) >
             margin * (1 + std::abs(threshold.cotangent)));
  };
  const auto is_clear = [&](double greatest) {
    return !is_near(greatest, thresholds[0]) && !is_near(greatest, thresholds[1]);
  };
  const auto one = greatest_cotangent_in_one_metric(t);
  if (one && is_clear(*one))
    return {*one > thresholds[0].cotangent, *one > thresholds[1].cotangent};
  const measured_angles m(t);
  std::array<bool, 2> below{};
  for (std::size_t i = 0; i < below.size(); ++i)
    below[i] = m.all_turn && !is_near(m.greatest, thresholds[i])
                   ? m.greatest > thresholds[i].cotangent
                   : smallest_of(m) < thresholds[i].degrees;
  return below;
}

double corner_angle(const site& corner, const point& first, const point& last) {
  const metric_tensor& m = corner.metric;
  const triangle_sites t = in_round_coordinates({corner, {first, m}, {last, m}});
  return angle_between(t[0].metric, difference(t[1].position, t[0].position),
                       difference(t[2].position, t[0].position));
}

double metric_circumradius(const triangle_sites& given) {
  return circumradius_in_round(in_round_coordinates(given));
}

double circumradius_in_round(const triangle_sites& t) {
  // Finds the near vertex of nearly every triangle by Newton's method from the centre of the mean
  // circle, at a tenth of the cost.
  if (const auto near = numeric::voronoi_vertex_near(t[0], t[1], t[2])) {
    const auto seen = apply(t[0].metric, *near);
    if (dot(seen, between(t[0].position, t[1].position)) > 0 &&
        dot(seen, between(t[0].position, t[2].position)) > 0)
      return std::sqrt(dot(seen, *near));
  }
  const auto vertices = voronoi_vertices(t[0], t[1], t[2]);
  if (vertices.empty()) return std::numeric_limits<double>::infinity();
  return std::sqrt(squared_distance(t[0], vertices.front()));
}

}  // namespace asterism::internal
