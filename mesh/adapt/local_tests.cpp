// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/local_tests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/vertex_hints.hpp"

namespace asterism::internal::adapting {
namespace {

// Margin above the angle bound, in degrees: far above the rounding errors of an angle, unless the
// triangle is nearly flat. It affects no result of the audit.
constexpr double degrees_to_spare = 0.05;

face_centre find_centre(const node& a, const node& b, const node& c) {
  // An error of 2^-24: far below the clearance that edges must have. It affects no result of the
  // audit.
  constexpr double last_step = 0x1p-12;
  const auto near = numeric::voronoi_vertex_near({a.position, a.metric}, {b.position, b.metric},
                                                 {c.position, c.metric}, last_step);
  if (!near) return {};
  return {{a.position.x + near->x, a.position.y + near->y}, squared(a.metric, near->x, near->y)};
}

// Returns the cotangent of the angle at a between b and c.
double cotangent_at(const metric_tensor& m, const node& a, const node& b, const node& c) {
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double inner = ux * (m.m11 * wx + m.m12 * wy) + uy * (m.m12 * wx + m.m22 * wy);
  return inner / (plain_root_of_determinant(m) * (ux * wy - uy * wx));
}

}  // namespace

double greatest_cotangent(const metric_tensor& m, double root, const node& a, const node& b,
                          const node& c) {
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double uu = squared(m, ux, uy), ww = squared(m, wx, wy),
               uw = ux * (m.m11 * wx + m.m12 * wy) + uy * (m.m12 * wx + m.m22 * wy);
  const double across = 1 / (root * (ux * wy - uy * wx));
  return std::max({uw, uu - uw, ww - uw}) * across;
}

double cotangent_of(double degrees) {
  constexpr double least = 1e-3;  // degrees: far below what is asked for. Steers only
  return 1 / elementary::tan(std::max(least, degrees) * std::numbers::pi / 180);
}

local_tests::local_tests(const editable_mesh& m, double angle_bound)
    : m_(m), angle_bound_(angle_bound), cotangent_(cotangent_of(angle_bound + degrees_to_spare)) {}

edge_quad local_tests::quad_at(vertex_index t, std::size_t i) const {
  const face& f = m_.faces()[t];
  const face& g = m_.faces()[f.next[i]];
  const vertex_index a = f.v[after(i)];
  return {a, f.v[before(i)], f.v[i], g.v[after(g.corner_of(a))]};
}

double local_tests::worst_clearance(const edge_quad& q) const {
  const node &a = m_.at(q.a), &b = m_.at(q.b), &c = m_.at(q.c), &d = m_.at(q.d);
  return std::min(clearance(find_centre(c, a, b), d), clearance(find_centre(d, b, a), c));
}

face_centre local_tests::centre_of(vertex_index t) const { return centre_of(m_.faces()[t].v); }

face_centre local_tests::centre_of(const std::array<vertex_index, 3>& v) const {
  return find_centre(m_.at(v[0]), m_.at(v[1]), m_.at(v[2]));
}

bool local_tests::is_low(vertex_index t) const {
  const face& f = m_.faces()[t];
  const node &a = m_.at(f.v[0]), &b = m_.at(f.v[1]), &c = m_.at(f.v[2]);
  for (const node* n : {&a, &b, &c})
    if (!(greatest_cotangent(n->metric, n->root, a, b, c) <= cotangent_)) return true;
  return false;
}

// True if an angle of t, other than the one at v, is below the bound in the metric of one of its
// three nodes.
bool local_tests::has_low_angle_beside(vertex_index t, vertex_index v) const {
  const face& f = m_.faces()[t];
  const std::size_t i = f.corner_of(v);
  const node &a = m_.at(v), &b = m_.at(f.v[after(i)]), &c = m_.at(f.v[before(i)]);
  for (const node* n : {&a, &b, &c})
    if (!(std::max(cotangent_at(n->metric, b, c, a), cotangent_at(n->metric, c, a, b)) <=
          cotangent_))
      return true;
  return false;
}

// True if the face is at a corner of the domain that is below the bound in the metric of its
// vertex. False if that corner meets the bound in the Euclidean metric while the face has other low
// angles: nothing exempts these, so the tensor at the corner must change.
bool local_tests::is_exempt(vertex_index t) const {
  for (const vertex_index v : m_.faces()[t].v) {
    if (m_.at(v).kind != node_kind::given) continue;
    vertex_index first = t, last = t;
    std::size_t steps = 0;
    face_list at;
    m_.around(v, at);
    const auto subsegment_after = [&](vertex_index s) {
      const face& f = m_.faces()[s];
      return f.segment[after(f.corner_of(v))];
    };
    const auto subsegment_before = [&](vertex_index s) {
      const face& f = m_.faces()[s];
      return f.segment[before(f.corner_of(v))];
    };
    while (subsegment_after(last) == none && ++steps < at.size())
      last = m_.faces()[last].next[after(m_.faces()[last].corner_of(v))];
    while (subsegment_before(first) == none && ++steps < 2 * at.size())
      first = m_.faces()[first].next[before(m_.faces()[first].corner_of(v))];
    if (subsegment_after(last) == none || subsegment_before(first) == none) continue;
    const point &o = m_.at(v).position,
                &p = m_.at(m_.faces()[first].v[after(m_.faces()[first].corner_of(v))]).position,
                &q = m_.at(m_.faces()[last].v[before(m_.faces()[last].corner_of(v))]).position;
    const metric_tensor& m = m_.at(v).metric;
    const double ux = p.x - o.x, uy = p.y - o.y, wx = q.x - o.x, wy = q.y - o.y;
    const double turned = m_.at(v).root * (ux * wy - uy * wx);
    const double inner = ux * (m.m11 * wx + m.m12 * wy) + uy * (m.m12 * wx + m.m22 * wy);
    const double bound = cotangent_of(angle_bound_);
    const bool is_sharp = turned > 0 && inner > bound * turned;
    const bool is_plainly_sharp = ux * wx + uy * wy > bound * (ux * wy - uy * wx);
    if (is_sharp && (is_plainly_sharp || !has_low_angle_beside(t, v))) return true;
  }
  return false;
}

}  // namespace asterism::internal::adapting
