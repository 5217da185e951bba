// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/ring_defect.hpp"

#include <algorithm>
#include <limits>

#include "asterism/mesh/adapt/editable_mesh.hpp"

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

// Returns the defect of the distance between a node with this tensor and a face's Voronoi vertex.
// Most are far enough away by a wide margin, which is decided without a division.
double defect_of_clearance(const face_centre& c, const metric_tensor& m, const point& at) {
  if (!(c.squared_radius > 0)) return defect(std::numeric_limits<double>::infinity());
  const double distance = squared(m, c.at.x - at.x, c.at.y - at.y);
  if (distance > (1 + roundings) * (1 + room_looked_for) * c.squared_radius) return 0;
  return defect(room_looked_for - (distance / c.squared_radius - 1));
}

}  // namespace

void ring_defect::clear() {
  spokes_.clear();
  centres_.clear();
}

void ring_defect::add_neighbour(const point& at, const wanted_tensor& wanted) {
  spokes_.push_back({at, wanted, {}, {}, 0});
}

void ring_defect::measure_from(const point& at, spoke& s) {
  const double x = s.at.x - at.x, y = s.at.y - at.y;
  s.from_node = {x, y};
  s.squares = {x * x, 2 * x * y, y * y};
  s.own_squared = measured(s.wanted.metric, s.squares);
}

ring_defect::face_products ring_defect::between(const spoke& p, const spoke& q) {
  const point &u = p.from_node, &w = q.from_node;
  const double across = u.x * w.y, back = u.y * w.x;
  return {{u.x * w.x, across + back, u.y * w.y}, across - back};
}

// Returns the defect of the angles of a face: of the excess of their greatest cotangent over the
// one without defect. Takes the squared lengths of two sides, their inner product and twice the
// area, all in one tensor. Most angles are above the aim by a wide margin, which is decided without
// a division.
double ring_defect::of_angles(double uu, double ww, double uw, double area) const {
  const double greatest = std::max({uw, uu - uw, ww - uw});
  const bool is_surely_wide = greatest < (1 - roundings) * cotangent_ * area;
  return is_surely_wide ? 0 : defect(greatest / area - cotangent_);
}

double ring_defect::of_others(const point& at, double most) {
  place_ = at;
  double sum = 0;
  if (!spokes_.empty()) measure_from(at, spokes_[0]);
  for (std::size_t k = 0; k + 1 < spokes_.size(); ++k) {
    const spoke& p = spokes_[k];
    spoke& q = spokes_[k + 1];
    measure_from(at, q);
    const face_products f = between(p, q);
    const wanted_tensor &by_p = p.wanted, &by_q = q.wanted;
    sum += of_angles(p.own_squared, measured(by_p.metric, q.squares),
                     measured(by_p.metric, f.inner), by_p.root * f.twice) +
           of_angles(measured(by_q.metric, p.squares), q.own_squared,
                     measured(by_q.metric, f.inner), by_q.root * f.twice);
    if (!(sum < most)) break;
  }
  return sum;
}

double ring_defect::of_own(const wanted_tensor& wanted, double most) const {
  constexpr double weight_of_clearance = 2;
  double sum = 0;
  double uu = spokes_.empty() ? 0 : measured(wanted.metric, spokes_[0].squares);
  for (std::size_t k = 0; k + 1 < spokes_.size(); ++k) {
    const face_products f = between(spokes_[k], spokes_[k + 1]);
    const double ww = measured(wanted.metric, spokes_[k + 1].squares);
    sum += of_angles(uu, ww, measured(wanted.metric, f.inner), wanted.root * f.twice);
    uu = ww;
  }
  for (const face_centre& c : centres_) {
    sum += weight_of_clearance * defect_of_clearance(c, wanted.metric, place_);
    if (!(sum < most)) break;
  }
  return sum;
}

}  // namespace asterism::internal::adapting
