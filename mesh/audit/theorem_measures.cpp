// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/theorem_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"

namespace asterism::internal::theorem {
namespace {

using namespace audit_detail;

constexpr double infinity = std::numeric_limits<double>::infinity();

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

// Returns the share of the way from p to q at which both are about equally far.
double middle_share(const site& p, const site& q) {
  const double from_p = distance(p, q).value(), from_q = distance(q, p).value();
  const double share = from_q / (from_p + from_q);
  return share > 0 && share < 1 ? share : 0.5;
}

// Returns about where all three are equally far, pulled onto the triangle.
place middle_place(const std::array<site, 3>& t) {
  const auto vertex = enclose_voronoi_vertex(t[0], t[1], t[2]);
  const offset to_b = between(t[0].position, t[1].position),
               to_c = between(t[0].position, t[2].position);
  const double area = cross(to_b, to_c).value();
  place p{1.0 / 3, 1.0 / 3};
  if (vertex) p = {cross(*vertex, to_c).value() / area, cross(to_b, *vertex).value() / area};
  if (!(std::abs(p.second) < infinity && std::abs(p.third) < infinity)) p = {1.0 / 3, 1.0 / 3};
  // Beyond the longest edge the vertex is replaced by the middle of that edge.
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

}  // namespace

double distance_above(const site& p, const site& q) {
  const double d = distance(p, q).upper();
  return d < infinity ? d : infinity;
}

// A point x of the triangle and one point on each edge cut it into six triangles, each with one
// corner of it; that is within R of all of such a triangle if it is of the two other points.
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

// The product of the sides over four times the area. Each point of a triangle is within that of the
// nearest corner, which is the centre's nearest site in the part that it is in.
double circumradius_above(const std::array<site, 3>& t) {
  const metric_tensor& metric = t[0].metric;
  if (!identical(metric, t[1].metric) || !identical(metric, t[2].metric)) return infinity;
  const tensor<bounded> m = tensor_of_doubles(metric);
  const offset a = between(t[0].position, t[1].position), b = between(t[0].position, t[2].position),
               c = between(t[1].position, t[2].position);
  const bounded area = cross(a, b);
  const bounded sides = square_norm(m, a) * square_norm(m, b) * square_norm(m, c);
  const double radius = root(sides / (bounded(4) * m.determinant() * area * area)).upper();
  return radius >= 0 ? radius : infinity;
}

// A line across u separates the disks if |u.d| > R (|u| as p's inverse metric measures + as q's).
// u = M_p d, then M_q d.
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
