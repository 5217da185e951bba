// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/curve_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"

namespace asterism::internal {
namespace {

constexpr double turn = 2 * std::numbers::pi;

double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }
point between(const point& a, const point& b, double t) {
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

// Returns the angle from u to v, in radians: above 0 and at most a full turn if counter-clockwise,
// the negative of that if clockwise.
double angle_between(const point& u, const point& v, bool clockwise) {
  const double angle = elementary::atan2(cross(u, v), dot(u, v));
  if (clockwise) return angle < 0 ? angle : angle - turn;
  return angle > 0 ? angle : angle + turn;
}

// Returns the control points of a part of a cubic: of that before t, or of that from t on.
std::array<point, 4> part_of_cubic(std::array<point, 4> p, double t, bool before) {
  std::array<point, 4> kept;
  for (std::size_t level = 0; level < 4; ++level) {
    kept[before ? level : 3 - level] = before ? p[0] : p[3 - level];
    for (std::size_t i = 0; i + level + 1 < 4; ++i) p[i] = between(p[i], p[i + 1], t);
  }
  return kept;
}

}  // namespace

curve_path::curve_path(const domain_curve& curve, const point& start, const point& end)
    : kind_(curve.kind), start_(start), end_(end), control_(curve.control), centre_(curve.centre) {
  if (kind_ != curve_kind::arc) return;
  const point u = minus(start, centre_), v = minus(end, centre_);
  radius_ = elementary::hypot(u.x, u.y);
  first_angle_ = elementary::atan2(u.y, u.x);
  sweep_ = start == end ? (curve.clockwise ? -turn : turn) : angle_between(u, v, curve.clockwise);
}

point curve_path::on_circle(double t, double reach) const {
  const double angle = first_angle_ + t * sweep_;
  return {centre_.x + reach * elementary::cos(angle), centre_.y + reach * elementary::sin(angle)};
}

point curve_path::at(double t) const {
  if (t <= 0) return start_;
  if (t >= 1) return end_;
  if (kind_ == curve_kind::arc) return on_circle(t, radius_);
  return part_of_cubic({start_, control_[0], control_[1], end_}, t, true)[3];
}

point curve_path::derivative(double t) const {
  if (kind_ == curve_kind::arc) {
    const double angle = first_angle_ + t * sweep_, speed = radius_ * sweep_;
    return {-speed * elementary::sin(angle), speed * elementary::cos(angle)};
  }
  const point a = minus(control_[0], start_), b = minus(control_[1], control_[0]),
              c = minus(end_, control_[1]);
  const point d = between(between(a, b, t), between(b, c, t), t);
  return {3 * d.x, 3 * d.y};
}

std::optional<double> curve_path::nearest(const point& q, double t0, double t1) const {
  // Bisects on a sign: the displacement from q to the curve's point goes backward along the curve
  // before the nearest point, and forward after it.
  const auto is_before = [&](double t) { return dot(minus(at(t), q), derivative(t)) < 0; };
  if (!is_before(t0) || is_before(t1)) return std::nullopt;
  constexpr int halvings = 54;  // the bits of a double
  double low = t0, high = t1;
  for (int i = 0; i < halvings; ++i) {
    const double t = low + (high - low) / 2;
    (is_before(t) ? low : high) = t;
  }
  if (low <= t0 || high >= t1) return std::nullopt;
  return high;
}

std::vector<point> curve_path::control_points(double t0, double t1) const {
  if (kind_ == curve_kind::arc) {
    const double half = (t1 - t0) * sweep_ / 2;
    return {at(t0), on_circle((t0 + t1) / 2, radius_ / elementary::cos(half)), at(t1)};
  }
  const auto until = part_of_cubic({start_, control_[0], control_[1], end_}, t1, true);
  const auto piece = part_of_cubic(until, t1 > 0 ? t0 / t1 : 0, false);
  return {at(t0), piece[1], piece[2], at(t1)};
}

double curve_path::height(double t0, double t1) const {
  if (kind_ == curve_kind::arc) {
    const double s = elementary::sin((t1 - t0) * sweep_ / 4);
    return 2 * radius_ * s * s;
  }
  const std::vector<point> p = control_points(t0, t1);
  const point chord = minus(p[3], p[0]);
  const double length = elementary::hypot(chord.x, chord.y);
  if (!(length > 0)) {
    const point a = minus(p[1], p[0]), b = minus(p[2], p[0]);
    return std::max(elementary::hypot(a.x, a.y), elementary::hypot(b.x, b.y));
  }
  // Uses that the Bernstein weights of a cubic's two inner control points sum to at most 3/4.
  return 0.75 / length *
         std::max(std::abs(cross(chord, minus(p[1], p[0]))),
                  std::abs(cross(chord, minus(p[2], p[0]))));
}

bool curve_path::is_straightforward(double t0, double t1) const {
  if (kind_ == curve_kind::arc) return std::abs((t1 - t0) * sweep_) <= turn / 8 * (1 + 0x1p-40);
  const std::vector<point> p = control_points(t0, t1);
  const point chord = minus(p[3], p[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if (!(dot(chord, minus(p[i + 1], p[i])) > 0)) return false;
  return true;
}

}  // namespace asterism::internal
