// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/triangle_distance.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::internal {
namespace {

double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

// Returns the place moved into the triangle: s, t >= 0 with s + t <= 1 exactly, where sums are
// rounded upward. From 1/2 on the difference 1 - s is exact.
triangle_place inside(double s, double t) {
  s = clamped(s), t = clamped(t);
  double more = std::max(s, t), less = std::min(s, t);
  if (more + less > 1) {
    more = std::max(more, 0.5);
    less = std::min(less, 1 - more);
  }
  return s < t ? triangle_place{less, more} : triangle_place{more, less};
}

double share_along(double along, double length) { return length > 0 ? clamped(along / length) : 0; }

double squared_distance(const measured_triangle& t, const triangle_place& at,
                        const plain_vector& p) {
  const plain_vector d = p - (t.corner + at.s * t.first + at.t * t.second);
  return dot(d, d);
}

template <class Number>
bool certainly_positive(const Number& x);
template <>
bool certainly_positive(const rounded_interval& x) {
  return x.inf() > 0;
}
template <>
bool certainly_positive(const dyadic& x) {
  return x.sign_value() == sign::positive;
}

template <class Number>
bool certainly_zero(const Number& x);
template <>
bool certainly_zero(const rounded_interval& x) {
  return x.inf() == 0 && x.sup() == 0;
}
template <>
bool certainly_zero(const dyadic& x) {
  return x.is_zero();
}

// True if p is certainly farther from the edge than the bound: from both ends, and from the edge's
// line unless p's foot on it is certainly beyond an end. p is given as w times its displacement
// from the edge's start.
template <class Number>
bool edge_is_farther(const space_vector<Number>& p, const space_vector<Number>& edge,
                     const Number& w, const Number& squared) {
  const Number bound = squared * w * w, length = dot(edge, edge), along = dot(p, edge);
  if (!certainly_positive(dot(p, p) - bound)) return false;
  const space_vector<Number> q = p - w * edge;
  if (!certainly_positive(dot(q, q) - bound)) return false;
  if (certainly_positive(-along) || certainly_positive(along - w * length)) return true;
  const space_vector<Number> area = cross(p, edge);
  return certainly_positive(dot(area, area) - bound * length) || certainly_zero(length);
}

}  // namespace

measured_triangle::measured_triangle(const plain_triangle& t)
    : corner(plain(t[0])),
      end(plain(t[1])),
      first(end - corner),
      second(plain(t[2]) - corner),
      first_squared(dot(first, first)),
      both(dot(first, second)),
      second_squared(dot(second, second)) {}

nearest_place nearest_in(const measured_triangle& triangle, const plain_vector& p) {
  const plain_vector &e = triangle.first, &f = triangle.second, d = p - triangle.corner;
  const double ee = triangle.first_squared, ef = triangle.both, ff = triangle.second_squared,
               de = dot(d, e), df = dot(d, f);
  const double area = ee * ff - ef * ef;
  if (area > 0) {
    const double s = (de * ff - df * ef) / area, t = (df * ee - de * ef) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) return {{s, t}, squared_distance(triangle, {s, t}, p)};
  }
  const triangle_place first = inside(share_along(de, ee), 0);
  const triangle_place second = inside(0, share_along(df, ff));
  const plain_vector from = p - triangle.end, opposite = f - e;
  const double along = share_along(dot(from, opposite), dot(opposite, opposite));
  const triangle_place third = inside(1 - along, along);
  nearest_place best{first, squared_distance(triangle, first, p)};
  for (const triangle_place& place : {second, third}) {
    const double far = squared_distance(triangle, place, p);
    if (far < best.squared_distance) best = {place, far};
  }
  return best;
}

nearest_place nearest_in(const plain_triangle& triangle, const plain_vector& p) {
  return nearest_in(measured_triangle(triangle), p);
}

distances_above::distances_above(const plain_triangle& triangle)
    : plain_(triangle),
      corner_(vector_of<rounded_interval>(triangle[0])),
      first_(vector_of<rounded_interval>(triangle[1]) - corner_),
      second_(vector_of<rounded_interval>(triangle[2]) - corner_) {}

interval_vector distances_above::nearest_to(const plain_vector& p) const {
  const nearest_place near = nearest_in(plain_, p);
  const triangle_place place = inside(near.at.s, near.at.t);
  return corner_ + scaled(place.s, first_) + scaled(place.t, second_);
}

double distances_above::of(const weighted_point& p) const {
  const plain_vector at = (1 / middle_of(p.weight)) * middle_of(p.at);
  const rounded_interval far = squared_length(p.at - p.weight * nearest_to(at));
  return quotient(far, squared(p.weight)).sup();
}

double distances_above::of(const interval_vector& p) const {
  return squared_length(p - nearest_to(middle_of(p))).sup();
}

template <class Number>
bool is_farther(const space_vector<Number>& p, const Number& w, const plain_triangle& triangle,
                const Number& squared) {
  const auto a = vector_of<Number>(triangle[0]), b = vector_of<Number>(triangle[1]),
             c = vector_of<Number>(triangle[2]);
  const space_vector<Number> from_a = p - w * a, from_b = p - w * b, from_c = p - w * c;
  if (!edge_is_farther(from_a, b - a, w, squared)) return false;
  if (!edge_is_farther(from_b, c - b, w, squared)) return false;
  if (!edge_is_farther(from_c, a - c, w, squared)) return false;
  const space_vector<Number> normal = cross(b - a, c - a);
  if (certainly_zero(dot(normal, normal))) return true;  // it is its edges
  const Number height = dot(from_a, normal);
  if (certainly_positive(height * height - squared * w * w * dot(normal, normal))) return true;
  // Tests points near the plane: the foot must certainly be beyond one of the edges.
  return certainly_positive(-dot(cross(b - a, from_a), normal)) ||
         certainly_positive(-dot(cross(c - b, from_b), normal)) ||
         certainly_positive(-dot(cross(a - c, from_c), normal));
}

template bool is_farther(const interval_vector&, const rounded_interval&, const plain_triangle&,
                         const rounded_interval&);
template bool is_farther(const exact_vector&, const dyadic&, const plain_triangle&, const dyadic&);

}  // namespace asterism::internal
