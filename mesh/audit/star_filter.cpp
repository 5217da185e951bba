// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asterism::internal::audit_detail {
namespace {

vector2<bounded> offset_of(const site& v, const site& z) {
  return {bounded(z.position.x) - bounded(v.position.x),
          bounded(z.position.y) - bounded(v.position.y)};
}

vector2<bounded> quarter_turn(const vector2<bounded>& a) { return {-a.y, a.x}; }

// The side of a gap, as gap_side describes it, in plain doubles.
struct plain_side {
  explicit plain_side(const gap_side& z)
      : offset{z.offset.x.value(), z.offset.y.value()},
        covector{z.covector.x.value(), z.covector.y.value()},
        inverse_length(z.inverse_length.value()),
        bend(z.bend) {}

  double bound(const vector2<double>& u, double length_squared) const {
    const double turned = u.x * offset.y - u.y * offset.x;
    const double radicand = std::max(0.0, length_squared - bend * turned * turned);
    return u.x * covector.x + u.y * covector.y + std::sqrt(radicand) * inverse_length;
  }

  vector2<double> offset, covector;
  double inverse_length, bend;
};

// A parameter of a function, with the value of the function at it.
struct sampled {
  double t, value;
};

// Returns about the zero of a function between a parameter where it is positive and one where it is
// not, by the Illinois method: secants through both ends of a range, where the value at an end that
// stays is halved.
template <class Function>
double zero_between(const Function& value_at, sampled positive, sampled other) {
  constexpr int most_steps = 20;
  constexpr double near = 0x1p-18;
  double last = positive.t;
  bool was_positive = false;
  for (int step = 0; step < most_steps; ++step) {
    const double share = positive.value / (positive.value - other.value);
    const double t = positive.t + (other.t - positive.t) * share, value = value_at(t);
    const bool is_positive = value > 0;
    (is_positive ? positive : other) = {t, value};
    if (step > 0 && is_positive == was_positive) (is_positive ? other : positive).value *= 0.5;
    if (!(std::abs(t - last) > near)) return t;
    last = t;
    was_positive = is_positive;
  }
  return last;
}

// Returns the direction in which the lower bounds of s_x and s_y are about equal, in plain doubles:
// any direction is a valid choice, a good one makes the filter strong. Between x and y the
// difference of the bounds changes sign once. Searches beyond one of them if it does not: obtuse
// triangles have their Voronoi vertex there.
vector2<double> balanced_direction(const gap_side& x_side, const gap_side& y_side,
                                   const metric_tensor& m) {
  const plain_side x(x_side), y(y_side);
  // Scales both ends to about unit length, so that t divides the angle evenly.
  const auto direction = [&](double t) {
    const double at_x = (1 - t) * x.inverse_length, at_y = t * y.inverse_length;
    return vector2<double>{at_x * x.offset.x + at_y * y.offset.x,
                           at_x * x.offset.y + at_y * y.offset.y};
  };
  const auto difference = [&](double t) {
    const vector2<double> u = direction(t);
    const double length_squared = u.x * (m.m11 * u.x + 2 * m.m12 * u.y) + m.m22 * u.y * u.y;
    return x.bound(u, length_squared) - y.bound(u, length_squared);
  };
  const auto sample = [&](double t) { return sampled{t, difference(t)}; };
  sampled at_x = sample(0), at_y = sample(1);
  if (!(at_x.value > 0)) {
    at_y = at_x;
    at_x = sample(-1);
  } else if (!(at_y.value < 0)) {
    at_x = at_y;
    at_y = sample(2);
  }
  if (!(at_x.value > 0)) return direction(at_x.t);
  if (!(at_y.value < 0)) return direction(at_y.t);
  return direction(zero_between(difference, at_x, at_y));
}

}  // namespace

gap_side::gap_side(const site& v, const site& z) : offset(offset_of(v, z)) {
  const tensor<bounded> own = tensor_of_doubles(z.metric), metric = tensor_of_doubles(v.metric);
  const vector2<bounded> dual = own * offset;
  const bounded length_squared = dot(offset, dual);
  v_covector = metric * offset;
  v_length_squared = dot(offset, v_covector);
  covector = {dual.x / length_squared, dual.y / length_squared};
  inverse_length = bounded(1) / root(length_squared);
  bend = greatest_bound((own.determinant() / length_squared).upper(),
                        (metric.determinant() / v_length_squared).upper());
}

bounded gap_side::bound(const vector2<bounded>& u, const bounded& length_squared) const {
  const bounded turned = cross(u, offset);
  const bounded radicand = length_squared - bounded(bend) * turned * turned;
  // Makes the bound prove nothing if its root is not certainly real.
  const bounded rooted = radicand.certainly_positive()
                             ? root(radicand)
                             : bounded::within(0, std::numeric_limits<double>::infinity());
  return dot(u, covector) + rooted * inverse_length;
}

double gap_side::reach_along_edge() const {
  const bounded length = root(v_length_squared);
  return greatest_bound((length / (bounded(1) + length * inverse_length)).upper(),
                        (length / bounded(2)).upper());
}

star_gap_filter::star_gap_filter(const site& v, const site& x, const site& y)
    : v_(v), x_(v, x), y_(v, y) {
  const tensor<bounded> metric = tensor_of_doubles(v.metric);
  const vector2<double> u = balanced_direction(x_, y_, v.metric);
  middle_ = {bounded(u.x), bounded(u.y)};
  middle_length_squared_ = dot(middle_, metric * middle_);
  middle_bound_x_ = x_.bound(middle_, middle_length_squared_);
  middle_bound_y_ = y_.bound(middle_, middle_length_squared_);
  // Excludes bounds that are not positive: they do not bound the distance along the ray.
  usable_ = dot(middle_, x_.v_covector).certainly_positive() &&
            dot(middle_, y_.v_covector).certainly_positive() &&
            middle_bound_x_.certainly_positive() && middle_bound_y_.certainly_positive();
}

double star_gap_filter::reach() const {
  if (!usable_) return std::numeric_limits<double>::infinity();
  const bounded length = root(middle_length_squared_);
  return greatest_bound(
      greatest_bound((length / middle_bound_x_).upper(), (length / middle_bound_y_).upper()),
      greatest_bound(x_.reach_along_edge(), y_.reach_along_edge()));
}

namespace {

// Upper bound of s_w, as a convex function of the direction.
struct upper_bound {
  upper_bound(const site& v, const site& w) : offset(offset_of(v, w)) {
    const tensor<bounded> own = tensor_of_doubles(w.metric), metric = tensor_of_doubles(v.metric);
    v_covector = metric * offset;
    v_length_squared = dot(offset, v_covector);
    dual = own * offset;
    inverse = bounded(1) / dot(offset, dual);
    inverse_length = root(inverse);
    determinant = metric.determinant();
    bend = std::fmin(positive_bound((own.determinant() * inverse).lower()),
                     positive_bound((determinant / v_length_squared).lower()));
  }

  bounded operator()(const vector2<bounded>& u, const bounded& u_length_squared) const {
    const bounded turned = cross(u, offset);
    return dot(u, dual) * inverse +
           root(u_length_squared - bounded(bend) * turned * turned) * inverse_length;
  }

  vector2<bounded> offset, v_covector, dual;
  bounded v_length_squared, inverse, inverse_length, determinant;
  double bend = 0;
};

// True if no direction between the middle one and `end` is left for w. `end` is at a right angle to
// w on the side of z. Either z's lower bound alone excludes w in all of these directions; or it
// does so up to some direction, and beyond it the triangle of v, w and the point on the ray
// contains z. `turned` is the area spanned by z and w, positive.
bool closed_towards(const gap_side& z, const upper_bound& w, const vector2<bounded>& end,
                    const bounded& turned) {
  const bounded end_length_squared = w.determinant * w.v_length_squared;
  const bounded at_end = w(end, end_length_squared);
  if (certainly_less(at_end, z.bound(end, end_length_squared))) return true;
  const bounded along = dot(z.v_covector, w.offset);
  return along.certainly_positive() &&
         certainly_less(at_end * turned, w.v_length_squared - along) &&
         certainly_less(w(z.offset, z.v_length_squared), bounded(1));
}

}  // namespace

bool star_gap_filter::excludes(const site& w) const {
  if (!usable_) return false;
  const upper_bound s(v_, w);
  if (!dot(middle_, s.v_covector).certainly_positive()) return false;
  const bounded at_middle = s(middle_, middle_length_squared_);
  if (!certainly_less(at_middle, middle_bound_x_) || !certainly_less(at_middle, middle_bound_y_))
    return false;
  const vector2<bounded> left = quarter_turn(s.v_covector);
  return closed_towards(x_, s, {-left.x, -left.y}, cross(x_.offset, s.offset)) &&
         closed_towards(y_, s, left, cross(s.offset, y_.offset));
}

}  // namespace asterism::internal::audit_detail
