// SPDX-License-Identifier: MIT
#include "conic.hpp"

namespace asterism::oracle {

conic operator-(const conic& a, const conic& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy, a.x - b.x, a.y - b.y, a.constant - b.constant};
}

conic operator*(const rational& factor, const conic& a) {
  return {factor * a.xx, factor * a.xy, factor * a.yy,
          factor * a.x,  factor * a.y,  factor * a.constant};
}

conic squared_distance(const exact_site& s) {
  const auto& [px, py] = s.position;
  const auto& [m11, m12, m22] = s.metric;
  const rational two(2);
  return {m11,
          two * m12,
          m22,
          -two * (m11 * px + m12 * py),
          -two * (m12 * px + m22 * py),
          m11 * px * px + two * m12 * px * py + m22 * py * py + s.offset};
}

conic bisector(const exact_site& v, const exact_site& w) {
  return squared_distance(v) - squared_distance(w);
}

conic line_through(const basic_point<rational>& p, const basic_point<rational>& q) {
  const rational dx = q.x - p.x, dy = q.y - p.y;
  return {rational(0), rational(0), rational(0), -dy, dx, dy * p.x - dx * p.y};
}

conic polar_line(const conic& g, const basic_point<rational>& p) {
  const rational half(1, 2);
  return {rational(0),
          rational(0),
          rational(0),
          g.xx * p.x + half * (g.xy * p.y + g.x),
          g.yy * p.y + half * (g.xy * p.x + g.y),
          half * (g.x * p.x + g.y * p.y) + g.constant};
}

conic tangent_pair(const conic& g, const basic_point<rational>& p) {
  const conic l = polar_line(g, p);
  const rational two(2);
  const conic polar_squared = {l.x * l.x,
                               two * l.x * l.y,
                               l.y * l.y,
                               two * l.x * l.constant,
                               two * l.y * l.constant,
                               l.constant * l.constant};
  return g.at(p) * g - polar_squared;
}

}  // namespace asterism::oracle
