// SPDX-License-Identifier: MIT
//
// Decides questions about given points and segments by rational arithmetic and real roots in one
// variable.
#include <algorithm>
#include <array>
#include <vector>

#include "conic.hpp"
#include "exact_numbers.hpp"
#include "oracle.hpp"

namespace asterism::oracle {
namespace {

using exact_point = basic_point<rational>;

// (q-p)^T M (r-p)
rational inner_product(const exact_site& s, const exact_point& q, const exact_point& r) {
  const rational ux = q.x - s.position.x, uy = q.y - s.position.y;
  const rational vx = r.x - s.position.x, vy = r.y - s.position.y;
  return ux * (s.metric.m11 * vx + s.metric.m12 * vy) +
         uy * (s.metric.m12 * vx + s.metric.m22 * vy);
}

// Interpolates g(from + t (to - from)) at t = 0, 1, -1.
univariate along_segment(const conic& g, const exact_point& from, const exact_point& to) {
  const exact_point back = {from.x + from.x - to.x, from.y + from.y - to.y};
  const rational at_zero = g.at(from), at_one = g.at(to), at_minus_one = g.at(back);
  const rational half(1, 2);
  return {at_zero, half * (at_one - at_minus_one), half * (at_one + at_minus_one) - at_zero};
}

int roots_in_closed_unit_interval(const univariate& p) {
  int count = 0;
  for (const algebraic_number& root : distinct_real_roots(p))
    if (!(root < algebraic_number(0)) && !(algebraic_number(1) < root)) ++count;
  return count;
}

}  // namespace

sign orientation(const point& p, const point& q, const point& r) {
  const exact_point a = to_exact(p), b = to_exact(q), c = to_exact(r);
  return to_sign(sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

// Uses Sylvester's criterion from the other end of the diagonal: m22 > 0 and a positive
// determinant.
bool is_positive_definite(const metric_tensor& metric) {
  const rational a(metric.m11), b(metric.m12), c(metric.m22);
  return sign_of(c) > 0 && sign_of(a * c - b * b) > 0;
}

// The determinant of the rows x, y, u^T m u, 1, without differences, expanded along the last
// column.
sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
               const point& p) {
  const rational m11(m.m11), m12(m.m12), m22(m.m22);
  std::array<std::array<rational, 3>, 4> row;
  const std::array<const point*, 4> points = {&a, &b, &c, &p};
  for (std::size_t k = 0; k < 4; ++k) {
    const exact_point u = to_exact(*points[k]);
    row[k] = {u.x, u.y, m11 * u.x * u.x + rational(2) * m12 * u.x * u.y + m22 * u.y * u.y};
  }
  const auto minor = [&row](std::size_t i, std::size_t j, std::size_t k) -> rational {
    const auto two = [&](std::size_t s, std::size_t t) -> rational {
      return row[s][0] * row[t][1] - row[s][1] * row[t][0];
    };
    return row[i][2] * two(j, k) - row[j][2] * two(i, k) + row[k][2] * two(i, j);
  };
  return to_sign(sign_of(minor(0, 1, 2) - minor(0, 1, 3) + minor(0, 2, 3) - minor(1, 2, 3)));
}

sign compare_distance(const site& v, const site& w, const point& q) {
  return to_sign(sign_of(bisector(to_exact(v), to_exact(w)).at(to_exact(q))));
}

bool in_wedge(const site& v, const site& w, const point& q) {
  const exact_site a = to_exact(v), b = to_exact(w);
  const exact_point p = to_exact(q);
  return sign_of(inner_product(a, p, b.position)) > 0 &&
         sign_of(inner_product(b, p, a.position)) > 0;
}

sign dominates(const site& v, const site& w, const point& p) {
  const exact_site a = to_exact(v), b = to_exact(w);
  const exact_point q = to_exact(p);
  const conic g = bisector(a, b);
  const int from_v = roots_in_closed_unit_interval(along_segment(g, a.position, q));
  const int from_w = roots_in_closed_unit_interval(along_segment(g, b.position, q));
  return to_sign(from_w - from_v);
}

bool encroaches(const site& a, const site& b, const site& w) {
  const exact_site ea = to_exact(a), eb = to_exact(b), ew = to_exact(w);
  const univariate over_a = along_segment(bisector(ew, ea), ea.position, eb.position);
  const univariate over_b = along_segment(bisector(ew, eb), ea.position, eb.position);
  std::vector<algebraic_number> cuts = {algebraic_number(0), algebraic_number(1)};
  // Neither is identically zero: the first is positive at a unless w is a, the other at b.
  for (const univariate& p : {over_a, over_b})
    for (const algebraic_number& root : distinct_real_roots(p)) cuts.push_back(root);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  for (const rational& t : samples_between(cuts))
    if (sign_of(t) > 0 && t < rational(1) && sign_of(evaluate(over_a, t)) < 0 &&
        sign_of(evaluate(over_b, t)) < 0)
      return true;
  return false;
}

}  // namespace asterism::oracle
