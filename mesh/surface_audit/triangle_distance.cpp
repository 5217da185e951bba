// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/triangle_distance.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::internal {
namespace {

double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

// Returns s, t >= 0 with s + t <= 1 exactly, where sums are rounded upward. From 1/2 on the
// difference 1 - s is exact.
triangle_place inside(double s, double t) {
  s = clamped(s), t = clamped(t);
  if (s < t) {
    const triangle_place other = inside(t, s);
    return {other.t, other.s};
  }
  if (s + t > 1) {
    s = std::max(s, 0.5);
    t = std::min(t, 1 - s);
  }
  return {s, t};
}

double share_along(const plain_vector& from, const plain_vector& edge, const plain_vector& p) {
  const double length = dot(edge, edge);
  return length > 0 ? clamped(dot(p - from, edge) / length) : 0;
}

double squared_distance(const plain_triangle& t, const triangle_place& at, const plain_vector& p) {
  const plain_vector a = plain(t[0]);
  const plain_vector d = p - (a + at.s * (plain(t[1]) - a) + at.t * (plain(t[2]) - a));
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

// True if p, from the edge's start and times w, is certainly farther than the bound from the edge:
// from both ends, and from the line unless the foot on it is certainly beyond an end.
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

nearest_place nearest_in(const plain_triangle& triangle, const plain_vector& p) {
  const plain_vector a = plain(triangle[0]);
  const plain_vector e = plain(triangle[1]) - a, f = plain(triangle[2]) - a, d = p - a;
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), de = dot(d, e), df = dot(d, f);
  const double area = ee * ff - ef * ef;
  if (area > 0) {
    const double s = (de * ff - df * ef) / area, t = (df * ee - de * ef) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) return {{s, t}, squared_distance(triangle, {s, t}, p)};
  }
  const triangle_place first = inside(share_along(a, e, p), 0);
  const triangle_place second = inside(0, share_along(a, f, p));
  const double along = share_along(plain(triangle[1]), f - e, p);
  const triangle_place third = inside(1 - along, along);
  nearest_place best{first, squared_distance(triangle, first, p)};
  for (const triangle_place& place : {second, third}) {
    const double far = squared_distance(triangle, place, p);
    if (far < best.squared_distance) best = {place, far};
  }
  return best;
}

double squared_distance_above(const weighted_point& p, const plain_triangle& triangle) {
  const plain_vector at = (1 / middle_of(p.weight)) * middle_of(p.at);
  const nearest_place near = nearest_in(triangle, at);
  const triangle_place place = inside(near.at.s, near.at.t);
  const interval_vector a = vector_of<rounded_interval>(triangle[0]);
  const interval_vector q =
      a + rounded_interval(place.s) * (vector_of<rounded_interval>(triangle[1]) - a) +
      rounded_interval(place.t) * (vector_of<rounded_interval>(triangle[2]) - a);
  const rounded_interval far = squared_length(p.at - p.weight * q);
  return quotient(far, squared(p.weight)).sup();
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
  // Nearer to the plane: the foot is certainly beyond one of the edges.
  return certainly_positive(-dot(cross(b - a, from_a), normal)) ||
         certainly_positive(-dot(cross(c - b, from_b), normal)) ||
         certainly_positive(-dot(cross(a - c, from_c), normal));
}

template bool is_farther(const interval_vector&, const rounded_interval&, const plain_triangle&,
                         const rounded_interval&);
template bool is_farther(const exact_vector&, const dyadic&, const plain_triangle&, const dyadic&);

}  // namespace asterism::internal
