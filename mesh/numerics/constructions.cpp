// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/constructions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/numerics/real_roots.hpp"

namespace asterism::internal {
namespace {

point operator-(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }
point operator+(const point& a, const point& b) { return {a.x + b.x, a.y + b.y}; }
point operator*(double t, const point& a) { return {t * a.x, t * a.y}; }
metric_tensor operator-(const metric_tensor& a, const metric_tensor& b) {
  return {a.m11 - b.m11, a.m12 - b.m12, a.m22 - b.m22};
}

bool finite(const point& q) { return std::isfinite(q.x) && std::isfinite(q.y); }

// Returns J M d: perpendicular to d as M measures.
point perpendicular(const metric_tensor& m, const point& d) {
  return {-(m.m12 * d.x + m.m22 * d.y), m.m11 * d.x + m.m12 * d.y};
}

point half_gradient(const site& s, const point& q) {
  const point u = q - s.position;
  return {s.metric.m11 * u.x + s.metric.m12 * u.y, s.metric.m12 * u.x + s.metric.m22 * u.y};
}

// Brings coordinates and metrics to about unit size around the first site, by powers of two, so
// that scaling is exact. Where a metric is thin, coordinates in which it is round are used first.
struct frame {
  point origin;
  std::optional<round_coordinates> round;
  double length = 1, stretch = 1;

  template <std::size_t N>
  explicit frame(const std::array<site, N>& sites) : origin(sites[0].position) {
    for (const site& s : sites)
      if (!round && is_thin(s.metric)) round.emplace(origin, s.metric);
    double reach = 0, steepest = 0;
    for (const site& s : sites) {
      const site at = around_origin(s);
      reach = std::max({reach, std::abs(at.position.x), std::abs(at.position.y)});
      steepest = std::max({steepest, at.metric.m11, at.metric.m22});
    }
    length = std::ldexp(1.0, std::ilogb(reach));
    stretch = std::ldexp(1.0, std::ilogb(steepest));
  }
  site around_origin(const site& s) const {
    return round ? round->inward(s) : site{s.position - origin, s.metric};
  }
  site inward(const site& s) const {
    const auto [d, m] = around_origin(s);
    return {{d.x / length, d.y / length}, {m.m11 / stretch, m.m12 / stretch, m.m22 / stretch}};
  }
  point outward(const point& q) const {
    const point d = length * q;
    return origin + (round ? round->outward(d) : d);
  }
};

// Coefficients of the bisector of v and w on the lines v + u / s, u = d + m n: C s^2 - B s - A = 0.
struct line_equation {
  coefficients<2> A;
  coefficients<1> B;
  coefficients<0> C;

  line_equation(const site& v, const site& w, const point& d, const point& n) {
    const metric_tensor difference = v.metric - w.metric;
    const point to_w = w.position - v.position;
    A = {inner_product(difference, d, d), 2 * inner_product(difference, d, n),
         inner_product(difference, n, n)};
    B = {2 * inner_product(w.metric, d, to_w), 2 * inner_product(w.metric, n, to_w)};
    C = {inner_product(w.metric, to_w, to_w)};
  }
};

// Improves q by Newton's method for f_a = f_b = f_c. Returns nothing when the iteration leaves the
// plane or does not reach a zero.
//
// Each step squares the error where bisectors cross. Where they touch, it halves the error; the
// difference of the squared distances is about the square of the error, so that 20 steps leave
// 2^-40 of it. A step of 1e-15 is about the rounding of the point. The limit on the remaining
// difference was found with 20,000 random triples for each of 15 kinds (aspects 1 to 30, metrics
// alike or up to e^3 apart): all but one start in a thousand led either to less than 1e-11 of the
// squared distance, at a common point, or to more than 1e-6.
std::optional<point> polish(const std::array<site, 3>& s, point q) {
  constexpr int most_steps = 20;
  constexpr double no_step = 1e-15, most_missed = 1e-9;
  for (int step = 0; step < most_steps; ++step) {
    const double f0 = squared_distance(s[0], q);
    const double g1 = f0 - squared_distance(s[1], q), g2 = f0 - squared_distance(s[2], q);
    const point h0 = half_gradient(s[0], q);
    const point h1 = 2.0 * (h0 - half_gradient(s[1], q)), h2 = 2.0 * (h0 - half_gradient(s[2], q));
    const double jacobian = h1.x * h2.y - h1.y * h2.x;
    const point move{(g1 * h2.y - g2 * h1.y) / jacobian, (g2 * h1.x - g1 * h2.x) / jacobian};
    if (!finite(move)) break;
    q = q - move;
    if (elementary::hypot(move.x, move.y) <= no_step * elementary::hypot(q.x, q.y)) break;
  }
  const double f0 = squared_distance(s[0], q);
  const double miss =
      std::max(std::abs(f0 - squared_distance(s[1], q)), std::abs(f0 - squared_distance(s[2], q)));
  if (!finite(q) || !(miss <= most_missed * f0)) return std::nullopt;
  return q;
}

// Adds q unless it is one of the points already. For the random triples of polish(), approximations
// of one point are less than 1e-8 apart, except for one pair, and those of different points more
// than 1e-4.
void add_once(std::vector<point>& points, const std::optional<point>& q) {
  constexpr double same = 1e-7;
  if (!q) return;
  for (const point& p : points) {
    const point d = p - *q;
    if (elementary::hypot(d.x, d.y) <= same * (1 + elementary::hypot(q->x, q->y))) return;
  }
  points.push_back(*q);
}

// Returns the circumcentre in the mean of the three metrics: exact when they are equal, which is
// where the resultant below degenerates.
point mean_circumcentre(const std::array<site, 3>& s) {
  metric_tensor m{};
  for (const site& one : s) {
    m.m11 += one.metric.m11 / 3;
    m.m12 += one.metric.m12 / 3;
    m.m22 += one.metric.m22 / 3;
  }
  const point d = s[1].position - s[0].position, e = s[2].position - s[0].position;
  const double dd = inner_product(m, d, d) / 2, ee = inner_product(m, e, e) / 2;
  const point md{m.m11 * d.x + m.m12 * d.y, m.m12 * d.x + m.m22 * d.y};
  const point me{m.m11 * e.x + m.m12 * e.y, m.m12 * e.x + m.m22 * e.y};
  const double det = md.x * me.y - md.y * me.x;
  return s[0].position + point{(dd * me.y - ee * md.y) / det, (ee * md.x - dd * me.x) / det};
}

// Returns approximate common points, from the resultant of the two bisectors along lines through
// s[0].
std::vector<point> resultant_points(const std::array<site, 3>& s) {
  const point d = s[1].position - s[0].position;
  point n = perpendicular(s[0].metric, d);
  n = std::sqrt(inner_product(s[0].metric, d, d) / inner_product(s[0].metric, n, n)) * n;
  const line_equation p(s[0], s[1], d, n), q(s[0], s[2], d, n);
  const coefficients<2> e = combine(-p.C[0], q.A, q.C[0], p.A);
  const coefficients<1> f = combine(-p.C[0], q.B, q.C[0], p.B);
  const coefficients<3> g = combine(1, multiply(p.B, q.A), -1, multiply(q.B, p.A));
  const coefficients<4> resultant = combine(1, multiply(e, e), -1, multiply(f, g));
  std::vector<point> found;
  for (const double m : real_roots({resultant.begin(), resultant.end()})) {
    const double A = p.A[0] + m * (p.A[1] + m * p.A[2]), B = p.B[0] + m * p.B[1];
    for (const double t : quadratic_roots(p.C[0], -B, -A))
      if (t != 0) found.push_back(s[0].position + (1 / t) * (d + m * n));
  }
  return found;
}

// Adds the points where the line through v perpendicular (in v's metric) to v w first meets the
// bisector, either way. There v's wedge ends; as the first point of the bisector on the line, it is
// visible from v.
void exits_from(const site& v, const site& w, std::vector<point>& exits) {
  const point d = w.position - v.position, n = perpendicular(v.metric, d);
  const double a = inner_product(v.metric, n, n) - inner_product(w.metric, n, n);
  const double b = 2 * inner_product(w.metric, n, d), c = inner_product(w.metric, d, d);
  const std::vector<double> reciprocals = quadratic_roots(c, -b, -a);
  if (reciprocals.empty()) return;
  const auto add = [&](double t) {
    const point q = v.position + (1 / t) * n;
    if (finite(q)) exits.push_back(q);
  };
  if (reciprocals.back() > 0) add(reciprocals.back());
  if (reciprocals.front() < 0) add(reciprocals.front());
}

}  // namespace

std::vector<point> voronoi_vertices(const site& a, const site& b, const site& c) {
  std::array<site, 3> s{a, b, c};
  std::sort(s.begin(), s.end(), [](const site& p, const site& q) {
    return lexicographically_less(p.position, q.position);
  });
  const frame unit(s);
  for (site& one : s) one = unit.inward(one);
  std::vector<point> starts = resultant_points(s);
  starts.insert(starts.begin(), mean_circumcentre(s));
  std::vector<point> vertices;
  for (const point& q : starts) add_once(vertices, polish(s, q));
  std::sort(vertices.begin(), vertices.end(), [&](const point& p, const point& q) {
    return squared_distance(s[0], p) < squared_distance(s[0], q);
  });
  for (point& q : vertices) q = unit.outward(q);
  std::erase_if(vertices, [](const point& q) { return !finite(q); });
  return vertices;
}

std::vector<point> wedge_exits(const site& v, const site& w) {
  std::array<site, 2> s{v, w};
  if (lexicographically_less(w.position, v.position)) std::swap(s[0], s[1]);
  const frame unit(s);
  for (site& one : s) one = unit.inward(one);
  std::vector<point> exits;
  exits_from(s[0], s[1], exits);
  exits_from(s[1], s[0], exits);
  for (point& q : exits) q = unit.outward(q);
  return exits;
}

point bisector_point(const site& a, const site& b) {
  const point d = b.position - a.position;
  const double from_a = std::sqrt(squared_length(a.metric, d));
  const double from_b = std::sqrt(squared_length(b.metric, d));
  return a.position + (from_b / (from_a + from_b)) * d;
}

point point_at_distance(const site& a, const point& b, double distance) {
  const point d = b - a.position;
  return a.position + (distance / std::sqrt(squared_length(a.metric, d))) * d;
}

}  // namespace asterism::internal
