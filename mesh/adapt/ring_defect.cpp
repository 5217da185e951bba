// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/ring_defect.hpp"

#include <algorithm>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::adapting {
namespace {

// Clearance at which moves aim: more than edges are to keep, since tensors around change
// afterwards.
constexpr double room_looked_for = 0.3;
// Bound of the relative rounding errors of a product or quotient here, which are some 1e-16.
constexpr double roundings = 1e-12;

// Returns the defect of a quantity that exceeds its limit by this amount. The defect is bounded:
// moves do not help a quantity far beyond its limit.
double defect(double beyond) {
  constexpr double most = 1, of_any = 0.1;
  return beyond > 0 ? std::min(most, beyond) + of_any : 0;
}

double greater(double a, double b) { return a < b ? b : a; }

}  // namespace

void ring_defect::put(std::size_t k, const point& at, const wanted_tensor& wanted) {
  x_[k] = at.x;
  y_[k] = at.y;
  m11_[k] = wanted.metric.m11;
  m12_[k] = wanted.metric.m12;
  m22_[k] = wanted.metric.m22;
  root_[k] = wanted.root;
}

void ring_defect::add_neighbour(const point& at, const wanted_tensor& wanted) {
  put(neighbours_, at, wanted);
  ++neighbours_;
  put(neighbours_, at, wanted);  // padding, unless another one follows
}

void ring_defect::add_centre(const face_centre& c) {
  centre_x_[centres_] = c.at.x;
  centre_y_[centres_] = c.at.y;
  squared_radius_[centres_] = c.squared_radius;
  far_[centres_] =
      c.squared_radius > 0 ? (1 + roundings) * (1 + room_looked_for) * c.squared_radius : infinity;
  ++centres_;
}

// Computes what the angles of all faces depend on in any tensor, with the node at this place.
void ring_defect::measure_from(point place) {
  place_ = place;
  const std::size_t padded = faces() + faces() % 2;
  for (std::size_t k = 0; k <= padded; ++k) {
    const double x = x_[k] - place.x, y = y_[k] - place.y;
    to_x_[k] = x;
    to_y_[k] = y;
    xx_[k] = x * x;
    xy_[k] = 2 * x * y;
    yy_[k] = y * y;
    own_[k] = m11_[k] * xx_[k] + m12_[k] * xy_[k] + m22_[k] * yy_[k];
  }
  for (std::size_t k = 0; k < padded; ++k) {
    const double across = to_x_[k] * to_y_[k + 1], back = to_y_[k] * to_x_[k + 1];
    inner_xx_[k] = to_x_[k] * to_x_[k + 1];
    inner_xy_[k] = across + back;
    inner_yy_[k] = to_y_[k] * to_y_[k + 1];
    twice_[k] = across - back;
  }
}

// Returns the defect of the angles of a face: of the excess of their greatest cotangent over the
// one without defect. Most angles are above the aim by a wide margin, which is decided without a
// division.
double ring_defect::of_angles(const cotangents& c, std::size_t k) const {
  return c.below[k] > 0 ? 0 : defect(c.greatest[k] / c.area[k] - cotangent_);
}

double ring_defect::of_others(const point& at, double most) {
  measure_from(at);
  const std::size_t padded = faces() + faces() % 2;
  const double sure = (1 - roundings) * cotangent_;
  cotangents &p = by_first_, &q = by_second_;
  for (std::size_t k = 0; k < padded; ++k) {
    const std::size_t l = k + 1;
    const double inner_p = m11_[k] * inner_xx_[k] + m12_[k] * inner_xy_[k] + m22_[k] * inner_yy_[k],
                 inner_q = m11_[l] * inner_xx_[k] + m12_[l] * inner_xy_[k] + m22_[l] * inner_yy_[k],
                 by_p = m11_[k] * xx_[l] + m12_[k] * xy_[l] + m22_[k] * yy_[l],
                 by_q = m11_[l] * xx_[k] + m12_[l] * xy_[k] + m22_[l] * yy_[k];
    p.greatest[k] = greater(greater(inner_p, own_[k] - inner_p), by_p - inner_p);
    q.greatest[k] = greater(greater(inner_q, by_q - inner_q), own_[l] - inner_q);
    p.area[k] = root_[k] * twice_[k];
    q.area[k] = root_[l] * twice_[k];
    p.below[k] = sure * p.area[k] - p.greatest[k];
    q.below[k] = sure * q.area[k] - q.greatest[k];
  }
  double sum = 0;
  for (std::size_t k = 0; k < faces(); ++k) {
    sum += of_angles(p, k) + of_angles(q, k);
    if (!(sum < most)) break;
  }
  return sum;
}

// Returns `sum` plus the defect of the distances between a node with this tensor and the Voronoi
// vertices of the faces across. Most are far enough away by a wide margin, which is decided without
// a division.
double ring_defect::of_centres(metric_tensor m, double most, double sum) {
  constexpr double weight = 2;
  const point place = place_;
  for (std::size_t k = 0; k < centres_; ++k) {
    const double x = centre_x_[k] - place.x, y = centre_y_[k] - place.y;
    distance_[k] = x * (m.m11 * x + 2 * m.m12 * y) + m.m22 * y * y;
  }
  for (std::size_t k = 0; k < centres_; ++k) {
    if (!(distance_[k] > far_[k])) {
      const double radius = squared_radius_[k];
      sum += weight * defect(radius > 0 ? room_looked_for - (distance_[k] / radius - 1) : infinity);
    }
    if (!(sum < most)) break;
  }
  return sum;
}

double ring_defect::of_own(const wanted_tensor& wanted, double most) {
  const metric_tensor m = wanted.metric;
  const std::size_t padded = faces() + faces() % 2;
  const double sure = (1 - roundings) * cotangent_, root = wanted.root;
  cotangents& c = by_node_;
  for (std::size_t k = 0; k < padded; ++k) {
    const std::size_t l = k + 1;
    const double inner = m.m11 * inner_xx_[k] + m.m12 * inner_xy_[k] + m.m22 * inner_yy_[k],
                 u = m.m11 * xx_[k] + m.m12 * xy_[k] + m.m22 * yy_[k],
                 w = m.m11 * xx_[l] + m.m12 * xy_[l] + m.m22 * yy_[l];
    c.greatest[k] = greater(greater(inner, u - inner), w - inner);
    c.area[k] = root * twice_[k];
    c.below[k] = sure * c.area[k] - c.greatest[k];
  }
  double sum = 0;
  for (std::size_t k = 0; k < faces(); ++k) sum += of_angles(c, k);
  return of_centres(m, most, sum);
}

}  // namespace asterism::internal::adapting
