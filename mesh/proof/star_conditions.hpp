// SPDX-License-Identifier: MIT
//
// The conditions under which a witness shows that a star keeps a neighbour, or refuses another
// site. docs/math/proof-format.md states and proves what each of them implies.
//
// Notation: f_s(p) is the square of the distance from the site s to p in the metric of s; a gap of
// the star of v runs from its neighbour x counter-clockwise to y. A witness is given in steps of
// 2^-26 of two edges, so that every condition is a polynomial in the doubles of the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "asterism/mesh/proof/number.hpp"

namespace asterism::internal::proof_detail {

inline constexpr double grid_step = 0x1p-26;
inline constexpr std::int64_t grid_size = std::int64_t{1} << 26;
// Width of the window of an edge's witness, in steps.
inline constexpr std::int64_t window = 64;

// A point v + (a X + b Y) 2^-26.
struct grid_point {
  std::int64_t a = 0, b = 0;
};

template <class Number>
vector2<Number> place(const grid_point& q, const vector2<Number>& x, const vector2<Number>& y) {
  return Number(static_cast<double>(q.a) * grid_step) * x +
         Number(static_cast<double>(q.b) * grid_step) * y;
}

// The points that span a gap's region, from one on the ray to x counter-clockwise to one on the ray
// to y, as offsets from v; and their squared distances in the metrics of v, x and y.
template <class Number, std::size_t Capacity>
struct gap_region {
  std::size_t count = 0;
  std::array<vector2<Number>, Capacity> at;
  // For each point p: its squared distance from v, and the scalar product of p and the point
  // before, both in v's metric.
  std::array<Number, Capacity> own, before;
  Number on_x, on_y;  // squares of the distances from x and y to the first point and the last
  vector2<Number> x, y;
};

template <class Number, std::size_t Capacity>
gap_region<Number, Capacity> make_region(const site& v, const site& x, const site& y,
                                         std::span<const grid_point> points) {
  gap_region<Number, Capacity> r;
  const tensor<Number> metric(v.metric);
  r.x = way<Number>(v.position, x.position);
  r.y = way<Number>(v.position, y.position);
  for (const grid_point& q : points) {
    const std::size_t i = r.count++;
    r.at[i] = place<Number>(q, r.x, r.y);
    const vector2<Number> dual = metric * r.at[i];
    r.own[i] = dot(dual, r.at[i]);
    if (i > 0) r.before[i] = dot(dual, r.at[i - 1]);
  }
  r.on_x = tensor<Number>(x.metric).square(r.at[0] - r.x);
  r.on_y = tensor<Number>(y.metric).square(r.at[r.count - 1] - r.y);
  return r;
}

// True if every point of the segment from the point i of a region to the next is no nearer to v
// than to z, and its direction from v within a right angle of z's. `z` is given by its offset from
// v: then each ray from v meets the bisector of v and z no later than the segment (lemma 2).
template <class Number, std::size_t Capacity>
uncertain_bool is_behind(const gap_region<Number, Capacity>& r, std::size_t i,
                         const vector2<Number>& to_z, const site& v, const site& z) {
  const tensor<Number> own(v.metric), other(z.metric);
  const vector2<Number> dual = own * to_z, p = r.at[i] - to_z, q = r.at[i + 1] - to_z,
                        seen = other * q;
  const Number at_p = r.own[i] - other.square(p), at_q = r.own[i + 1] - dot(seen, q),
               between = r.before[i + 1] - dot(seen, p);
  return exceeds_zero(dot(dual, r.at[i])) & exceeds_zero(dot(dual, r.at[i + 1])) &
         reaches_zero(at_p) & reaches_zero(at_q) &
         (reaches_zero(between) | reaches_zero(at_p * at_q - between * between));
}

// True if w is farther than v from every point of the region, and farther than x, or y, from the
// rest of the edge from v to it: all coefficients of the differences in the Bernstein basis are
// positive (theorem 3).
template <class Number, std::size_t Capacity>
uncertain_bool is_refused(const gap_region<Number, Capacity>& r, const site& v, const site& w) {
  const tensor<Number> metric(w.metric);
  const vector2<Number> to_w = way<Number>(v.position, w.position), dual = metric * to_w;
  std::array<vector2<Number>, Capacity> seen;
  uncertain_bool refused = true;
  for (std::size_t i = 0; i < r.count; ++i) {
    const vector2<Number> from_w = r.at[i] - to_w;
    seen[i] = metric * from_w;
    refused = refused & exceeds_zero(Number(0) - dot(dual, from_w)) &
              exceeds_zero(dot(seen[i], from_w) - r.own[i]);
    if (i > 0) refused = refused & exceeds_zero(dot(seen[i - 1], from_w) - r.before[i]);
    if (refused.certainly(false)) return false;
  }
  const auto beyond = [&](std::size_t i, const vector2<Number>& z, const Number& square) {
    return exceeds_zero(dot(seen[i], r.at[i] - to_w) - square) &
           exceeds_zero(dot(seen[i], z - to_w));
  };
  return refused & beyond(0, r.x, r.on_x) & beyond(r.count - 1, r.y, r.on_y);
}

// The four sites of an inner edge: v and w, its ends, with x on its right and y on its left.
struct edge_sites {
  const site &v, &w, &x, &y;
};

// True if f_z - f_s is positive on the triangle of s and two points: if its six coefficients in the
// Bernstein basis are. A coefficient that belongs to s and one point may also be negative, if its
// square is less than the coefficient of s times each of the three coefficients that belong to
// points alone.
template <class Number>
uncertain_bool is_nearest(const site& s, const site& z, const point& origin,
                          const std::array<vector2<Number>, 2>& p) {
  const tensor<Number> own(s.metric), other(z.metric);
  const vector2<Number> to_s = way<Number>(origin, s.position),
                        to_z = way<Number>(origin, z.position);
  const std::array<vector2<Number>, 2> from_s = {p[0] - to_s, p[1] - to_s},
                                       from_z = {p[0] - to_z, p[1] - to_z};
  const std::array<vector2<Number>, 2> seen = {other * from_z[0], other * from_z[1]};
  const vector2<Number> edge = to_s - to_z;
  const std::array<Number, 3> beyond = {dot(seen[0], from_z[0]) - own.square(from_s[0]),
                                        dot(seen[1], from_z[1]) - own.square(from_s[1]),
                                        dot(seen[0], from_z[1]) - dot(from_s[0], own * from_s[1])};
  uncertain_bool nearest =
      exceeds_zero(beyond[0]) & exceeds_zero(beyond[1]) & exceeds_zero(beyond[2]);
  for (const vector2<Number>& dual : seen) {
    if (nearest.certainly(false)) return false;
    const Number product = dot(dual, edge);
    const uncertain_bool ahead = exceeds_zero(product);
    if (ahead.certainly(true)) continue;
    const Number at_s = other.square(edge), square = product * product;
    const auto exceeds_square = [&](const Number& b) { return exceeds_zero(at_s * b - square); };
    nearest = nearest & (ahead | (exceeds_square(beyond[0]) & exceeds_square(beyond[1]) &
                                  exceeds_square(beyond[2])));
  }
  return nearest;
}

// True if a point between the two of the witness shows that v keeps w and w keeps v (theorem 2).
// The two points are v + (a X + b Y) 2^-26, with X from v to w and Y from v to y, and v + ((a + 64)
// X + b Y) 2^-26.
template <class Number>
uncertain_bool is_kept(const edge_sites& e, const grid_point& first) {
  const point& origin = e.v.position;
  const vector2<Number> d = way<Number>(origin, e.w.position),
                        y = way<Number>(origin, e.y.position),
                        x = way<Number>(origin, e.x.position);
  const std::array<vector2<Number>, 2> p = {place<Number>(first, d, y),
                                            place<Number>({first.a + window, first.b}, d, y)};
  const tensor<Number> by_v(e.v.metric), by_w(e.w.metric);
  const auto excess = [&](const vector2<Number>& q) { return by_v.square(q) - by_w.square(q - d); };
  uncertain_bool kept = exceeds_zero(Number(0) - excess(p[0])) & exceeds_zero(excess(p[1]));
  const vector2<Number> dual_v = by_v * d, dual_w = by_w * d;
  for (const vector2<Number>& q : p)
    kept = kept & exceeds_zero(dot(dual_v, q)) & exceeds_zero(dot(dual_w, d - q));
  if (kept.certainly(false)) return false;
  for (const site* z : {&e.x, &e.y})
    kept = kept & is_nearest<Number>(e.v, *z, origin, p) & is_nearest<Number>(e.w, *z, origin, p);
  if (kept.certainly(false)) return false;
  const auto both = [&](const auto& test) { return test(p[0]) & test(p[1]); };
  const uncertain_bool without_y =
      both([&](const auto& q) { return reaches_zero(Number(0) - cross(d, q)); }) |
      both([&](const auto& q) { return exceeds_zero(cross(q, y)); }) |
      both([&](const auto& q) { return exceeds_zero(Number(0) - cross(q - d, y - d)); });
  const uncertain_bool without_x =
      both([&](const auto& q) { return reaches_zero(cross(d, q)); }) |
      both([&](const auto& q) { return exceeds_zero(Number(0) - cross(q, x)); }) |
      both([&](const auto& q) { return exceeds_zero(cross(q - d, x - d)); });
  return kept & without_x & without_y;
}

// True if every point of the segment from a to b is farther from the site than the radius, in the
// metric. `a` and `b` are offsets from the site.
template <class Number>
uncertain_bool is_out_of_reach(const tensor<Number>& metric, const vector2<Number>& a,
                               const vector2<Number>& b, const Number& squared_radius) {
  const vector2<Number> dual = metric * a;
  const Number of_a = dot(dual, a), of_b = metric.square(b), product = dot(dual, b);
  const uncertain_bool ends =
      exceeds_zero(of_a - squared_radius) & exceeds_zero(of_b - squared_radius);
  if (ends.certainly(false)) return false;
  return ends & (reaches_zero(product - of_a) | reaches_zero(product - of_b) |
                 exceeds_zero(of_a * of_b - product * product -
                              squared_radius * (of_a + of_b - Number(2) * product)));
}

// True if four sites of one metric, x on the right and y on the left of the segment from v to w,
// keep the edge: y is outside the circle of v, w and x, or on it and the greatest of the four is no
// end of the edge.
bool is_kept_in_one_metric(const site& v, const site& w, const site& x, const site& y);

inline bool have_one_metric(const site& a, const site& b, const site& c, const site& d) {
  return a.metric == b.metric && b.metric == c.metric && c.metric == d.metric;
}

}  // namespace asterism::internal::proof_detail
