// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit_star_filter.hpp"

#include <algorithm>
#include <limits>

namespace asterism::audit_detail {
namespace {

vector2<bounded> offset_of(const site& v, const site& z) {
  return {bounded(z.position.x) - bounded(v.position.x),
          bounded(z.position.y) - bounded(v.position.y)};
}

tensor<bounded> bounded_metric(const site& s) {
  return {bounded(s.metric.m11), bounded(s.metric.m12), bounded(s.metric.m22)};
}

// Bounds of a coefficient that must not be ignored when they overflowed to something not a number.
double greatest(double a, double b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return a < infinity && b < infinity ? std::max(a, b) : infinity;
}
double least_or_zero(double a, double b) { return a > 0 && b > 0 ? std::min(a, b) : 0; }

vector2<bounded> quarter_turn(const vector2<bounded>& a) { return {-a.y, a.x}; }

// The direction in which the lower bounds of both sides are about equal, in plain doubles: any
// direction is a valid choice, a good one makes the filter strong. Between x and y the difference
// of the bounds changes sign once; the secant through both ends is refined by bisection.
vector2<double> balanced_direction(const gap_side& x, const gap_side& y,
                                   const tensor<bounded>& metric) {
  const auto difference = [&](double t) {
    // Ends scaled to about unit length, so that t moves evenly.
    const double x_scale = x.inverse_length.value(), y_scale = y.inverse_length.value();
    const vector2<bounded> u = {
        bounded((1 - t) * x.offset.x.value() * x_scale + t * y.offset.x.value() * y_scale),
        bounded((1 - t) * x.offset.y.value() * x_scale + t * y.offset.y.value() * y_scale)};
    const bounded length_squared = dot(u, metric * u);
    return std::pair{u, x.bound(u, length_squared).value() - y.bound(u, length_squared).value()};
  };
  // Obtuse triangles have their Voronoi vertex beyond x or y.
  double low = -1, high = 2;
  for (int i = 0; i < 20; ++i) {
    const double t = (low + high) / 2;
    (difference(t).second > 0 ? low : high) = t;
  }
  const vector2<bounded> u = difference((low + high) / 2).first;
  return {u.x.value(), u.y.value()};
}

}  // namespace

gap_side::gap_side(const site& v, const site& z) : offset(offset_of(v, z)) {
  const tensor<bounded> own = bounded_metric(z), metric = bounded_metric(v);
  const vector2<bounded> dual = own * offset;
  const bounded length_squared = dot(offset, dual);
  v_covector = metric * offset;
  covector = {dual.x / length_squared, dual.y / length_squared};
  inverse_length = bounded(1) / root(length_squared);
  bend = greatest((own.determinant() / length_squared).upper(),
                  (metric.determinant() / dot(offset, v_covector)).upper());
}

bounded gap_side::bound(const vector2<bounded>& u, const bounded& length_squared) const {
  const bounded turned = cross(u, offset);
  const bounded radicand = length_squared - bounded(bend) * turned * turned;
  // Where the root is not certainly real the bound proves nothing.
  const bounded rooted = radicand.certainly_positive()
                             ? root(radicand)
                             : bounded::within(0, std::numeric_limits<double>::infinity());
  return dot(u, covector) + rooted * inverse_length;
}

star_gap_filter::star_gap_filter(const site& v, const site& x, const site& y)
    : v_(v), x_(v, x), y_(v, y) {
  const tensor<bounded> metric = bounded_metric(v);
  const vector2<double> u = balanced_direction(x_, y_, metric);
  middle_ = {bounded(u.x), bounded(u.y)};
  middle_length_squared_ = dot(middle_, metric * middle_);
  usable_ = dot(middle_, x_.v_covector).certainly_positive() &&
            dot(middle_, y_.v_covector).certainly_positive();
  middle_bound_x_ = x_.bound(middle_, middle_length_squared_);
  middle_bound_y_ = y_.bound(middle_, middle_length_squared_);
}

bool star_gap_filter::excludes(const site& w) const {
  if (!usable_) return false;
  const tensor<bounded> own = bounded_metric(w), metric = bounded_metric(v_);
  const vector2<bounded> d = offset_of(v_, w);
  const vector2<bounded> seen = metric * d;
  if (!dot(middle_, seen).certainly_positive()) return false;

  const vector2<bounded> dual = own * d;
  const bounded length_squared = dot(d, dual), v_length_squared = dot(d, seen);
  const bounded inverse = bounded(1) / length_squared, inverse_length = root(inverse);
  const double bend = least_or_zero((own.determinant() * inverse).lower(),
                                    (metric.determinant() / v_length_squared).lower());
  const auto upper = [&](const vector2<bounded>& u, const bounded& u_length_squared) {
    const bounded turned = cross(u, d);
    return dot(u, dual) * inverse +
           root(u_length_squared - bounded(bend) * turned * turned) * inverse_length;
  };

  const bounded at_middle = upper(middle_, middle_length_squared_);
  if (!certainly_less(at_middle, middle_bound_x_) || !certainly_less(at_middle, middle_bound_y_))
    return false;
  // The ends of the half turn that w sees: perpendicular to w in the metric of v.
  const vector2<bounded> left = quarter_turn(seen), right = {-left.x, -left.y};
  const bounded end_length_squared = metric.determinant() * v_length_squared;
  return certainly_less(upper(right, end_length_squared), x_.bound(right, end_length_squared)) &&
         certainly_less(upper(left, end_length_squared), y_.bound(left, end_length_squared));
}

}  // namespace asterism::audit_detail
