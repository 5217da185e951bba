// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/exact_lengths.hpp"

#include <cmath>
#include <limits>

#include "asterism/core/dyadic.hpp"
#include "asterism/mesh/support/rational.hpp"

namespace asterism::internal {
namespace {

struct exact_vector {
  dyadic x, y;
};

exact_vector between(const point& from, const point& to) {
  return {dyadic(to.x) - dyadic(from.x), dyadic(to.y) - dyadic(from.y)};
}
dyadic dot(const exact_vector& u, const exact_vector& w) { return u.x * w.x + u.y * w.y; }
dyadic cross(const exact_vector& u, const exact_vector& w) { return u.x * w.y - u.y * w.x; }
dyadic squared_distance(const point& p, const point& q) {
  const exact_vector u = between(p, q);
  return dot(u, u);
}

// Returns the double nearest to a rational; the library's conversion may truncate.
double nearest_double(const rational& x) {
  const double cut = static_cast<double>(x);
  const double next = std::nextafter(cut, x < cut ? -std::numeric_limits<double>::infinity()
                                                  : std::numeric_limits<double>::infinity());
  if (!std::isfinite(next)) return cut;
  return abs(x - rational(next)) < abs(x - rational(cut)) ? next : cut;
}

}  // namespace

bool are_nearer(const point& p, const point& q, double distance) {
  return squared_distance(p, q) < dyadic(distance) * dyadic(distance);
}

bool is_nearer_to(const point& p, const point& q, const point& r) {
  return squared_distance(p, q) < squared_distance(p, r);
}

bool is_beside(const point& v, const point& a, const point& b, double distance) {
  const exact_vector ab = between(a, b), av = between(a, v);
  const dyadic along = dot(ab, av), length = dot(ab, ab), off = cross(ab, av);
  if (!(dyadic() < along && along < length)) return false;
  return !(dyadic(distance) * dyadic(distance) * length < off * off);
}

bool is_shorter(const point& p, const point& q, const point& a, const point& b) {
  return squared_distance(p, q) < squared_distance(a, b);
}

bool shortens(const point& v, const point& a, const point& b) {
  return is_shorter(a, v, a, b) && is_shorter(v, b, a, b);
}

point rounded_crossing(const point& a, const point& b, const point& c, const point& d) {
  const rational ux = rational(b.x) - a.x, uy = rational(b.y) - a.y;
  const rational wx = rational(d.x) - c.x, wy = rational(d.y) - c.y;
  const rational vx = rational(c.x) - a.x, vy = rational(c.y) - a.y;
  const rational t = (vx * wy - vy * wx) / (ux * wy - uy * wx);
  return {nearest_double(a.x + t * ux), nearest_double(a.y + t * uy)};
}

}  // namespace asterism::internal
