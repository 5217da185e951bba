// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/theorem_measures.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/sized_value.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::theorem {
namespace {

using namespace audit_detail;

bounded square_norm(const tensor<bounded>& m, const offset& u) { return dot(u, m * u); }

bounded distance(const site& p, const site& q) {
  return root(square_norm(tensor_of_doubles(p.metric), between(p.position, q.position)));
}

// A point of a triangle: its first corner + second * (b - a) + third * (c - a), with factors that
// are not negative and whose exact sum is at most 1.
struct place {
  double second = 0, third = 0;
};

offset at(const std::array<site, 3>& t, const place& p) {
  const offset to_b = between(t[0].position, t[1].position),
               to_c = between(t[0].position, t[2].position);
  return {bounded(p.second) * to_b.x + bounded(p.third) * to_c.x,
          bounded(p.second) * to_b.y + bounded(p.third) * to_c.y};
}

// Returns the t at which p + t (q - p) is about equally far from p and q, each by its own metric.
double middle_share(const site& p, const site& q) {
  const double from_p = distance(p, q).value(), from_q = distance(q, p).value();
  const double share = from_q / (from_p + from_q);
  return share > 0 && share < 1 ? share : 0.5;
}

// Approximates the point equally far from all three corners, and moves it onto the triangle.
place middle_place(const std::array<site, 3>& t) {
  const auto vertex = enclose_voronoi_vertex(t[0], t[1], t[2]);
  const offset to_b = between(t[0].position, t[1].position),
               to_c = between(t[0].position, t[2].position);
  const double area = cross(to_b, to_c).value();
  place p{1.0 / 3, 1.0 / 3};
  if (vertex) p = {cross(*vertex, to_c).value() / area, cross(to_b, *vertex).value() / area};
  if (!(std::abs(p.second) < infinity && std::abs(p.third) < infinity)) p = {1.0 / 3, 1.0 / 3};
  // Replaces a vertex beyond the longest edge by the middle of that edge.
  if (p.second < 0) return {0, middle_share(t[0], t[2])};
  if (p.third < 0) return {middle_share(t[0], t[1]), 0};
  constexpr double all_but = 1 - 0x1p-40;
  if (p.second + p.third > all_but) {
    const double share = middle_share(t[1], t[2]);
    return {(1 - share) * all_but, share * all_but};
  }
  return p;
}

// Returns tau^2 of p's and q's metrics, from above: the greater eigenvalue of q's in coordinates in
// which p's is the identity, or the inverse of the smaller. The discriminant is a sum of squares
// there.
double squared_distortion_above(const metric_tensor& p, const metric_tensor& q) {
  const tensor<bounded> m = tensor_of_doubles(p), n = tensor_of_doubles(q);
  const bounded own = m.determinant();
  const bounded n11 = n.m11 / m.m11, n12 = (n.m12 - m.m12 / m.m11 * n.m11) / root(own),
                determinant = n.determinant() / own, n22 = (n12 * n12 + determinant) / n11;
  const bounded half = bounded(0.5) * (n11 + n22), aside = bounded(0.5) * (n11 - n22);
  const bounded greatest = half + root(aside * aside + n12 * n12);
  return greatest_bound(1, greatest_bound(greatest.upper(), (greatest / determinant).upper()));
}

double root_above(double a) {
  const double r = root(bounded(a)).upper();
  return r < infinity ? r : infinity;
}

// --- Bounds in plain doubles, where a coarser bound is enough.

point plain_between(const site& from, const site& to) {
  return {to.position.x - from.position.x, to.position.y - from.position.y};
}

point covector(const metric_tensor& m, const point& u) {
  return {m.m11 * u.x + m.m12 * u.y, m.m12 * u.x + m.m22 * u.y};
}

// Returns a point relative to the first corner, after one Newton step towards the point equally far
// from all three corners.
point nearer_to_vertex(const std::array<site, 3>& t, const point& to_b, const point& to_c,
                       const point& x) {
  const point from_b{x.x - to_b.x, x.y - to_b.y}, from_c{x.x - to_c.x, x.y - to_c.y};
  const point a = covector(t[0].metric, x), b = covector(t[1].metric, from_b),
              c = covector(t[2].metric, from_c);
  const double square = x.x * a.x + x.y * a.y;
  const double excess_b = 0.5 * (square - (from_b.x * b.x + from_b.y * b.y)),
               excess_c = 0.5 * (square - (from_c.x * c.x + from_c.y * c.y));
  const point slope_b{b.x - a.x, b.y - a.y}, slope_c{c.x - a.x, c.y - a.y};
  const double inverse = 1 / (slope_b.x * slope_c.y - slope_b.y * slope_c.x);
  return {x.x + inverse * (excess_b * slope_c.y - excess_c * slope_b.y),
          x.y + inverse * (excess_c * slope_b.x - excess_b * slope_c.x)};
}

// Returns an approximation of the point equally far from all three corners, as a place of the
// triangle: one Newton step from the centre of the circle through them in the sum of their metrics;
// the middle of an edge if the point is beyond that edge. Callers assume only that the place is not
// outside the triangle. `to_b` and `to_c` are vectors from the first corner.
place plain_middle_place(const std::array<site, 3>& t, const point& to_b, const point& to_c) {
  constexpr double all_but = 1 - 0x1p-40;
  metric_tensor m{0, 0, 0};
  for (const site& s : t) m = {m.m11 + s.metric.m11, m.m12 + s.metric.m12, m.m22 + s.metric.m22};
  const auto product = [&m](const point& u, const point& v) {
    return (m.m11 * u.x + m.m12 * u.y) * v.x + (m.m12 * u.x + m.m22 * u.y) * v.y;
  };
  const double bb = product(to_b, to_b), bc = product(to_b, to_c), cc = product(to_c, to_c);
  const double half_inverse = 0.5 / (bb * cc - bc * bc);
  const double second = cc * (bb - bc) * half_inverse, third = bb * (cc - bc) * half_inverse;
  const point x = nearer_to_vertex(
      t, to_b, to_c, {second * to_b.x + third * to_c.x, second * to_b.y + third * to_c.y});
  const double inverse_area = 1 / (to_b.x * to_c.y - to_b.y * to_c.x);
  const place p{(x.x * to_c.y - x.y * to_c.x) * inverse_area,
                (to_b.x * x.y - to_b.y * x.x) * inverse_area};
  if (!(std::abs(p.second) < infinity && std::abs(p.third) < infinity)) return {1.0 / 3, 1.0 / 3};
  if (p.second < 0) return {0, 0.5};
  if (p.third < 0) return {0.5, 0};
  if (p.second + p.third > all_but) return {0.5 * all_but, 0.5 * all_but};
  return p;
}

// Returns an upper bound of |q - p|_m for two points of a triangle, given as vectors from its first
// corner. `extent` has, for each coordinate, the sum of its absolute values at the two other
// corners, which bounds that coordinate of p, of q and of q - p. The computed difference is off by
// at most five roundings of `extent`, and the quadratic form by fifteen roundings of `size`, each
// of 2^-52 at most in any rounding mode. Underflow loses less than that in the range that is
// checked.
double plain_distance_above(const metric_tensor& m, const point& p, const point& q,
                            const point& extent) {
  const point d{q.x - p.x, q.y - p.y};
  const double square = (m.m11 * d.x + 2 * m.m12 * d.y) * d.x + m.m22 * d.y * d.y;
  const double size =
      (m.m11 * extent.x + 2 * std::abs(m.m12) * extent.y) * extent.x + m.m22 * extent.y * extent.y;
  const bool in_range = size > 0x1p-800 && size < 0x1p800 && extent.x + extent.y > 0x1p-400;
  return in_range ? std::sqrt(square + 0x1p-47 * size) * (1 + 0x1p-50) : infinity;
}

bool is_in_range(double size) { return size > 0x1p-800 && size < 0x1p800; }

// Returns the largest tau with which a pair at this distance exceeds no measure in `known`; 0 where
// none is certain. 1 - sigma d has an error below 2^-30 of it where it is not small.
double distortion_allowed(const pair_measures& known, double distance_below) {
  constexpr double down = 1 - 0x1p-28;
  const double left = 1 - known.variation_above * distance_below;
  const double t =
      left > 0x1p-20 ? std::min(known.distortion_above, down / left) : known.distortion_above;
  return t > 1 && t < 0x1p20 ? t : 0;
}

// Decides is_within() where the answer is clear: the compared values have errors of at most 2^-44
// of their magnitudes.
bool is_clearly_within(const pair_measures& known, const site& p, const site& q) {
  const point d = plain_between(p, q);
  const sized_value from_p = sized_square_norm(p.metric, d),
                    from_q = sized_square_norm(q.metric, d);
  const double least = std::min(from_p.below(), from_q.below()),
               apart = known.larger_distance_below * known.larger_distance_below;
  if (!(is_in_range(from_p.size) && is_in_range(from_q.size) && least > 0)) return false;
  if (!(std::max(from_p.below(), from_q.below()) > apart * (1 + 0x1p-40))) return false;
  const double t = distortion_allowed(known, std::sqrt(least)), c = t * t;
  const metric_tensor &m = p.metric, &n = q.metric;
  const sized_value own = sized_determinant(m), other = sized_determinant(n);
  if (!(t > 0 && is_in_range(own.size) && is_in_range(other.size))) return false;
  const double diagonal = m.m11 * n.m22 + m.m22 * n.m11, mixed = 2 * (m.m12 * n.m12);
  const double sum = diagonal - mixed, linear = c * sum, square = c * c, twice = 2 * c;
  const double error =
      0x1p-44 * (c * (diagonal + std::abs(mixed)) + (1 + square) * (own.size + other.size));
  return linear + error < square * own.value + other.value && sum + error < twice * own.value &&
         linear + error < square * other.value + own.value && sum + error < twice * other.value;
}

}  // namespace

double distance_above(const site& p, const site& q) {
  const double d = distance(p, q).upper();
  return d < infinity ? d : infinity;
}

// Bounds the covering radius of a triangle. A point x in it and one point on each edge cut it into
// six small triangles, each with one corner of the large one. Every point of a small triangle is
// within R of that corner if the two other vertices are.
double covering_radius_above(const std::array<site, 3>& t) {
  const offset x = at(t, middle_place(t));
  double radius = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const site &p = t[i], &q = t[(i + 1) % 3];
    const offset to_first = between(p.position, t[0].position);
    const offset to_x{to_first.x + x.x, to_first.y + x.y};
    radius = greatest_bound(radius, root(square_norm(tensor_of_doubles(p.metric), to_x)).upper());
    const bounded share(middle_share(p, q));
    radius = greatest_bound(radius, (share * distance(p, q)).upper());
    radius = greatest_bound(radius, ((bounded(1) - share) * distance(q, p)).upper());
  }
  return radius;
}

// Covers all points of the triangle: in the metric of a corner, none is farther from it than one of
// the other two corners.
double quick_covering_radius_above(const std::array<site, 3>& t, double enough) {
  const point to_b = plain_between(t[0], t[1]), to_c = plain_between(t[0], t[2]);
  const point extent{std::abs(to_b.x) + std::abs(to_c.x), std::abs(to_b.y) + std::abs(to_c.y)};
  const std::array<point, 3> corners = {point{0, 0}, to_b, to_c};
  std::array<double, 3> onwards, back;  // to the next corner, and from that
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    onwards[i] = plain_distance_above(t[i].metric, corners[i], corners[next], extent);
    back[i] = plain_distance_above(t[next].metric, corners[next], corners[i], extent);
    longest = greatest_bound(longest, greatest_bound(onwards[i], back[i]));
  }
  if (longest * (1 + 0x1p-20) < enough) return 0;
  const place x = plain_middle_place(t, to_b, to_c);
  const point to_x{x.second * to_b.x + x.third * to_c.x, x.second * to_b.y + x.third * to_c.y};
  double radius = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    radius = greatest_bound(radius, plain_distance_above(t[i].metric, corners[i], to_x, extent));
    const double share = back[i] / (onwards[i] + back[i]);
    if (!(share > 0 && share < 1)) return infinity;
    radius = greatest_bound(radius, greatest_bound(share * onwards[i], (1 - share) * back[i]));
  }
  return radius < infinity ? radius * (1 + 0x1p-50) : infinity;
}

// Tries lines that separate the disks: a line across u separates the disks if |u.d| > R (|u| in p's
// inverse metric + |u| in q's). Tries u = M_p d, then u = M_q d.
bool certainly_apart(const site& p, const site& q, double radius) {
  const auto separates = [radius](const site& first, const site& second) {
    const offset d = between(first.position, second.position);
    const tensor<bounded> m = tensor_of_doubles(first.metric), n = tensor_of_doubles(second.metric);
    const offset u = m * d;
    const bounded along = dot(d, u);
    const tensor<bounded> adjugate{n.m22, -n.m12, n.m11};
    const bounded other = root(square_norm(adjugate, u) / n.determinant());
    return (along - bounded(radius) * (root(along) + other)).certainly_positive();
  };
  return separates(p, q) || separates(q, p);
}

pair_measures measure_pair(const site& p, const site& q) {
  const bounded from_p = distance(p, q), from_q = distance(q, p);
  pair_measures pair;
  pair.larger_distance_below = positive_bound(std::max(from_p.lower(), from_q.lower()));
  if (identical(p.metric, q.metric)) return pair;
  pair.distortion_above = root_above(squared_distortion_above(p.metric, q.metric));
  const double nearest = std::min(from_p.lower(), from_q.lower());
  const double excess = (bounded(1) - bounded(1) / bounded(pair.distortion_above)).upper();
  pair.variation_above = quotient_above(excess, nearest);
  return pair;
}

// Decides by polynomials. tau <= t when no eigenvalue of M_p^-1 M_q or of its inverse is more than
// c = t^2. For M_p^-1 M_q this holds when c^2 |M_p| - c S + |M_q| > 0 and 2 c |M_p| > S, S the
// trace times
// |M_p|. sigma d <= s d when tau <= 1 / (1 - s d).
bool is_within(const pair_measures& known, const site& p, const site& q) {
  if (is_clearly_within(known, p, q)) return true;
  const offset d = between(p.position, q.position);
  const tensor<bounded> m = tensor_of_doubles(p.metric), n = tensor_of_doubles(q.metric);
  const bounded from_p = square_norm(m, d), from_q = square_norm(n, d);
  const bounded apart = bounded(known.larger_distance_below) * bounded(known.larger_distance_below);
  if (!certainly_less(apart, from_p) && !certainly_less(apart, from_q)) return false;
  if (identical(p.metric, q.metric)) return true;
  const bounded nearest = root(from_p.lower() < from_q.lower() ? from_p : from_q);
  const bounded left = bounded(1) - bounded(known.variation_above) * nearest;
  double t = known.distortion_above;
  if (left.certainly_positive()) t = std::min(t, (bounded(1) / left).lower());
  if (!(t > 1 && t < infinity)) return false;
  const bounded c = bounded(t) * bounded(t), own = m.determinant(), other = n.determinant();
  const bounded sum = m.m11 * n.m22 + m.m22 * n.m11 - bounded(2) * (m.m12 * n.m12);
  const bounded square = c * c, linear = c * sum, twice = bounded(2) * c;
  return certainly_less(linear, square * own + other) && certainly_less(sum, twice * own) &&
         certainly_less(linear, square * other + own) && certainly_less(sum, twice * other);
}

bool arcs_are_wedged(double radius, double spacing, double distortion) {
  const bounded tau(distortion);
  return (bounded(spacing) - bounded(radius) * tau * root(tau * tau - bounded(1)))
      .certainly_positive();
}

double table_variation_above(double variation, double radius, double distortion) {
  if (distortion == 1) return 0;
  const double product = (bounded(variation) * bounded(radius)).upper();
  const double cap = (bounded(1) - root(bounded(1) / bounded(distortion))).upper();
  return greatest_bound(product, cap);
}

double quotient_above(double a, double b) {
  if (!(b > 0)) return infinity;
  const double q = (bounded(a) / bounded(b)).upper();
  return q < infinity ? q : infinity;
}

}  // namespace asterism::internal::theorem
