// SPDX-License-Identifier: MIT
//
// The directions of the surface over a part of a triangle, in the triangle's own frame.
//
// With e its longest edge, n = E1 x E2 its normal, m = n x e, and p = e.q, r = m.q, c = n.q of a
// vector q, E = |e|^2 and N = |n|^2, two vectors have
//   q1 x q2 = ((p1 r2 - r1 p2) n - (p1 c2 - c1 p2) m + (r1 c2 - c1 r2) e) / (E N),
// so that the squared tangent of the angle between q1 x q2 and n is
//   E ((p1 c2 - c1 p2)^2 + (r1 c2 - c1 r2)^2 / N) / (p1 r2 - r1 p2)^2.
#include "asterism/mesh/surface_audit/lifted_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/surface_audit/part_directions.hpp"

namespace asterism::internal {
namespace {

triangle_frame frame_of(const lifted_scene& scene, const shell_triangle& t) {
  const auto at = [&](std::size_t k) {
    return vector_of<rounded_interval>(scene.space.mesh.points[t.vertex[k % 3]]);
  };
  triangle_frame f;
  f.corner = at(0);
  f.normal = cross(at(1) - f.corner, at(2) - f.corner);
  double longest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const interval_vector e = at(k + 1) - at(k);
    const double length = squared_length(e).sup();
    if (length > longest) longest = length, f.edge = e;
  }
  f.across = cross(f.normal, f.edge);
  f.squared_edge = squared_length(f.edge);
  f.squared_normal = squared_length(f.normal);
  return f;
}

direction_range in_frame(const triangle_frame& f, const interval_vector& q) {
  return {dot(f.edge, q), dot(f.across, q), dot(f.normal, q)};
}

void include(std::optional<direction_range>& range, const direction_range& q) {
  if (!range)
    range = q;
  else
    range = {hull(range->p, q.p), hull(range->r, q.r), hull(range->c, q.c)};
}

double infinite() { return std::numeric_limits<double>::infinity(); }

double squared_tangent_above(const triangle_frame& f, const two_directions& q) {
  const direction_range &x = q.first, &y = q.second;
  rounded_interval along = x.p * y.r - x.r * y.p;
  if (q.negative) along = -along;
  if (!(along.inf() > 0) || !(f.squared_normal.inf() > 0)) return infinite();
  const rounded_interval across =
      f.squared_edge *
      (squared(x.p * y.c - x.c * y.p) + quotient(squared(x.r * y.c - x.c * y.r), f.squared_normal));
  return quotient(across, squared(rounded_interval(along.inf()))).sup();
}

// A piece turned and mirrored so that its degenerate side, which is one point, is the side t = 0,
// with that point as the origin.
struct turned_piece {
  int degree_s = 0, degree_t = 0;
  std::vector<weighted_point> net;
  bool negative = false;
  std::size_t row() const { return static_cast<std::size_t>(degree_t) + 1; }
};

enum class piece_side { s_low, s_high, t_low, t_high };

turned_piece turned(const bezier_piece& from, piece_side side) {
  const bool transposed = side == piece_side::s_low || side == piece_side::s_high;
  const bool mirrored = side == piece_side::s_high || side == piece_side::t_high;
  turned_piece to;
  to.degree_s = transposed ? from.degree_v : from.degree_u;
  to.degree_t = transposed ? from.degree_u : from.degree_v;
  to.negative = transposed != mirrored;
  for (int i = 0; i <= to.degree_s; ++i)
    for (int j = 0; j <= to.degree_t; ++j) {
      const int at = mirrored ? to.degree_t - j : j;
      const auto row = static_cast<std::size_t>(transposed ? at : i);
      const auto column = static_cast<std::size_t>(transposed ? i : at);
      to.net.push_back(from.net[row * from.row() + column]);
    }
  return to;
}

parameter_triangle turned(const parameter_triangle& from, piece_side side) {
  parameter_triangle to = from;
  for (parameter_corner& c : to) {
    if (side == piece_side::s_low || side == piece_side::s_high) std::swap(c.s, c.t);
    if (side == piece_side::s_high || side == piece_side::t_high) c.t = rounded_interval(1) - c.t;
  }
  return to;
}

direction_range range_of(const triangle_frame& f, const triangle_net& net) {
  std::optional<direction_range> range;
  for (const weighted_point& c : net.points) include(range, in_frame(f, c.at));
  return *range;
}

rounded_interval weights_of(const triangle_net& net) {
  rounded_interval range = net.points[0].weight;
  for (const weighted_point& c : net.points) range = hull(range, c.weight);
  return range;
}

// Computes r_s / t and r_t, times w, where the side t = 0 is one point: with the point as origin
// the first row of control points is zero, and R_s = t G, R = t Q. Then r_s w = t (G - (Q / w) w_s)
// and r_t w = R_t - t (Q / w) w_t. A polynomial has no w.
two_directions from_one_point(const triangle_frame& f, turned_piece p, const parameter_triangle& at,
                              const space_point& origin, bool is_rational) {
  const interval_vector zero = vector_of<rounded_interval>(origin);
  for (weighted_point& c : p.net) c.at = c.at - c.weight * zero;
  const std::size_t row = p.row(), rows = p.net.size() / row;
  for (std::size_t i = 0; i < rows; ++i) p.net[i * row].at = {0, 0, 0};
  const double ds = p.degree_s, dt = p.degree_t;
  std::vector<weighted_point> g, q, by_t, by_s_weight;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 1; j < row; ++j) {
      const weighted_point& c = p.net[i * row + j];
      const rounded_interval share = quotient(rounded_interval(dt), static_cast<double>(j));
      q.push_back({share * c.at, 1});
      const weighted_point& before = p.net[i * row + j - 1];
      by_t.push_back({rounded_interval(dt) * (c.at - before.at),
                      rounded_interval(dt) * (c.weight - before.weight)});
      if (i + 1 == rows) continue;
      const weighted_point& next = p.net[(i + 1) * row + j];
      g.push_back({share * (rounded_interval(ds) * (next.at - c.at)), 1});
    }
  const auto net = [&](const std::vector<weighted_point>& points, int degree_s, int degree_t,
                       bool weighted) {
    return net_over({degree_s, degree_t, points.data()}, at, weighted);
  };
  direction_range first = range_of(f, net(g, p.degree_s - 1, p.degree_t - 1, false));
  const triangle_net second = net(by_t, p.degree_s, p.degree_t - 1, is_rational);
  direction_range last = range_of(f, second);
  if (!is_rational) return {first, last, p.negative};
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j < row; ++j)
      by_s_weight.push_back(
          {{0, 0, 0},
           rounded_interval(ds) * (p.net[(i + 1) * row + j].weight - p.net[i * row + j].weight)});
  const rounded_interval w = weights_of(net(p.net, p.degree_s, p.degree_t, true));
  const direction_range place =
      quotient(rounded_interval(1), w) * range_of(f, net(q, p.degree_s, p.degree_t - 1, false));
  const rounded_interval w_s = weights_of(net(by_s_weight, p.degree_s - 1, p.degree_t, true));
  rounded_interval t = at[0].t;
  for (const parameter_corner& c : at) t = hull(t, c.t);
  first = first - w_s * place;
  last = last - (t * weights_of(second)) * place;
  return {first, last, p.negative};
}

// Returns differences of a piece's control points in one direction. `origin` is subtracted first,
// times the weight.
std::vector<weighted_point> differences(const bezier_piece& p, const interval_vector& origin,
                                        bool by_s) {
  const auto rows = static_cast<std::size_t>(p.degree_u) + (by_s ? 0 : 1);
  const std::size_t count = p.row() - (by_s ? 0 : 1), to = by_s ? p.row() : 1;
  const auto moved = [&](const weighted_point& c) { return c.at - c.weight * origin; };
  std::vector<weighted_point> all;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const weighted_point &a = p.net[i * p.row() + j], &b = p.net[i * p.row() + j + to];
      all.push_back({moved(b) - moved(a), b.weight - a.weight});
    }
  return all;
}

// Bounds the derivatives of the surface by s and by t, times the weight w and positive factors. A
// part that a knot cut off may be so narrow that its own sides are nearly parallel: then these
// derivatives give useful bounds, and differences along the sides do not.
two_directions along_parameters(const triangle_frame& f, const bezier_piece& p,
                                const parameter_triangle& at, const triangle_net& net) {
  const auto by_s = differences(p, f.corner, true), by_t = differences(p, f.corner, false);
  const triangle_net first = net_over({p.degree_u - 1, p.degree_v, by_s.data()}, at, p.is_rational),
                     second =
                         net_over({p.degree_u, p.degree_v - 1, by_t.data()}, at, p.is_rational);
  const two_directions plain{range_of(f, first), range_of(f, second), false};
  if (!p.is_rational) return plain;
  std::optional<direction_range> place;
  for (const weighted_point& c : net.points)
    include(place, in_frame(f, quotient(c.at - c.weight * f.corner, c.weight)));
  return {plain.first - weights_of(first) * *place, plain.second - weights_of(second) * *place,
          false};
}

bool is_at(const parameter_corner& c, piece_side side) {
  const rounded_interval& x = side == piece_side::s_low || side == piece_side::s_high ? c.s : c.t;
  const double end = side == piece_side::s_high || side == piece_side::t_high ? 1 : 0;
  return x.inf() == end && x.sup() == end;
}

// Returns the squared tangent of the angle between the normals at a place of the piece, in doubles;
// -1 where the surface is folded over the triangle there.
double squared_tangent_at(const bezier_piece& piece, const plain_vector& own, double s, double t) {
  const plain_jet jet = evaluate(piece, s, t);
  const plain_vector normal = cross(jet.by_s, jet.by_t), across = cross(normal, own);
  const double along = dot(normal, own);
  return along > 0 ? dot(across, across) / (along * along) : -1;
}

// Proposes the greatest angle over a part: from its middle, which shows whether it is folded, and
// from places near its corners, where normals that turn evenly are farthest from the triangle's.
// Not at the corners themselves, as there is no normal where a side is one point.
double squared_tangent_below(const bezier_piece& piece, const parameter_triangle& corners,
                             const plain_vector& own) {
  constexpr double near = 63.0 / 64;
  std::array<double, 3> s, t;
  for (std::size_t k = 0; k < 3; ++k)
    s[k] = middle_of(corners[k].s), t[k] = middle_of(corners[k].t);
  const double middle_s = (s[0] + s[1] + s[2]) / 3, middle_t = (t[0] + t[1] + t[2]) / 3;
  double most = squared_tangent_at(piece, own, middle_s, middle_t);
  for (std::size_t k = 0; k < 3 && most >= 0; ++k)
    most = std::max(most, squared_tangent_at(piece, own, middle_s + near * (s[k] - middle_s),
                                             middle_t + near * (t[k] - middle_t)));
  return most;
}

}  // namespace

[[gnu::noinline]] void look_at_normals(const lifted_scene& scene, lifted_cell& cell,
                                       const triangle_net& net) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const triangle_frame f = frame_of(scene, scene.triangles[cell.triangle]);
  const auto directions = along_sides(f, net, piece.is_rational);
  cell.above = directions ? squared_tangent_above(f, *directions) : infinite();
  if (cell.is_cut || std::isinf(cell.above))
    cell.above = std::min(cell.above,
                          squared_tangent_above(f, along_parameters(f, piece, cell.corners, net)));
  for (std::size_t k = 0; k < 4 && std::isinf(cell.above); ++k) {
    const auto side = static_cast<piece_side>(k);
    const auto stands_there = [&](const parameter_corner& c) { return is_at(c, side); };
    if (!piece.is_point[k] || std::none_of(cell.corners.begin(), cell.corners.end(), stands_there))
      continue;
    const auto q = from_one_point(f, turned(piece, side), turned(cell.corners, side),
                                  piece.point[k], piece.is_rational);
    cell.above = squared_tangent_above(f, q);
  }
  cell.below = squared_tangent_below(piece, cell.corners, middle_of(f.normal));
}

}  // namespace asterism::internal
