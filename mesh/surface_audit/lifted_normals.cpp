// SPDX-License-Identifier: MIT
//
// The directions of the surface over a part of a triangle, in the triangle's own frame.
//
// With e its longest edge, n = E1 x E2 its normal, m = n x e, and p = e.q, r = m.q, c = n.q of a
// vector q, E = |e|^2 and N = |n|^2, two vectors have
//   q1 x q2 = ((p1 r2 - r1 p2) n - (p1 c2 - c1 p2) m + (r1 c2 - c1 r2) e) / (E N),
// so that the squared tangent of the angle between q1 x q2 and n is
//   E ((p1 c2 - c1 p2)^2 + (r1 c2 - c1 r2)^2 / N) / (p1 r2 - r1 p2)^2.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/surface_audit/lifted_bounds.hpp"

namespace asterism::internal {
namespace {

struct triangle_frame {
  interval_vector corner, edge, across, normal;
  rounded_interval squared_edge, squared_normal;
};

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

// Ranges of p, r and c over a part.
struct direction_range {
  rounded_interval p, r, c;

  friend direction_range operator-(const direction_range& x, const direction_range& y) {
    return {x.p - y.p, x.r - y.r, x.c - y.c};
  }
  friend direction_range operator*(const rounded_interval& s, const direction_range& x) {
    return {s * x.p, s * x.r, s * x.c};
  }
};

direction_range in_frame(const triangle_frame& f, const interval_vector& q) {
  return {dot(f.edge, q), dot(f.across, q), dot(f.normal, q)};
}

void include(std::optional<direction_range>& range, const direction_range& q) {
  if (!range)
    range = q;
  else
    range = {hull(range->p, q.p), hull(range->r, q.r), hull(range->c, q.c)};
}

// Two vector fields over a part, whose cross product is a positive multiple of r_u x r_v, or a
// negative one.
struct two_directions {
  direction_range first, second;
  bool negative = false;
};

double squared_tangent_above(const triangle_frame& f, const two_directions& q) {
  const direction_range &x = q.first, &y = q.second;
  rounded_interval along = x.p * y.r - x.r * y.p;
  if (q.negative) along = -along;
  if (!(along.inf() > 0) || !(f.squared_normal.inf() > 0))
    return std::numeric_limits<double>::infinity();
  const rounded_interval across =
      f.squared_edge *
      (squared(x.p * y.c - x.c * y.p) + quotient(squared(x.r * y.c - x.c * y.r), f.squared_normal));
  return quotient(across, squared(rounded_interval(along.inf()))).sup();
}

// The net with its points from `origin` on, times the weight.
void move_to(triangle_net& net, const interval_vector& origin) {
  for (weighted_point& c : net.points) c.at = c.at - c.weight * origin;
}

// The derivatives along the part's own sides, times n and w: differences of the net, and of a
// quotient less r w'.
two_directions along_sides(const triangle_frame& f, triangle_net net, bool is_rational) {
  move_to(net, f.corner);
  const int n = net.degree;
  std::array<std::optional<direction_range>, 2> range;
  std::array<std::optional<rounded_interval>, 2> weight;
  for (int i = n - 1; i >= 0; --i)
    for (int j = n - 1 - i; j >= 0; --j) {
      const weighted_point& from = net.points[net_index(n, i + 1, j)];
      const std::array<std::size_t, 2> to = {net_index(n, i, j + 1), net_index(n, i, j)};
      for (std::size_t k = 0; k < 2; ++k) {
        include(range[k], in_frame(f, net.points[to[k]].at - from.at));
        if (!is_rational) continue;
        const rounded_interval change = net.points[to[k]].weight - from.weight;
        weight[k] = weight[k] ? hull(*weight[k], change) : change;
      }
    }
  if (!is_rational) return {*range[0], *range[1], false};
  std::optional<direction_range> place;
  for (const weighted_point& c : net.points) include(place, in_frame(f, quotient(c.at, c.weight)));
  return {*range[0] - *weight[0] * *place, *range[1] - *weight[1] * *place, false};
}

// A piece turned and mirrored so that t = 0 is its side that is one point, which is the origin.
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

// r_s / t and r_t where the side t = 0 is one point, times w: with the point as origin the first
// row of control points is zero, and R_s = t G, R = t Q. Then r_s w = t (G - (Q / w) w_s) and r_t w
// = R_t - t (Q / w) w_t. A polynomial has no w.
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

bool is_at(const parameter_corner& c, piece_side side) {
  const rounded_interval& x = side == piece_side::s_low || side == piece_side::s_high ? c.s : c.t;
  const double end = side == piece_side::s_high || side == piece_side::t_high ? 1 : 0;
  return x.inf() == end && x.sup() == end;
}

}  // namespace

[[gnu::noinline]] void look_at_normals(const lifted_scene& scene, lifted_cell& cell,
                                       const triangle_net& net) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const shell_triangle& t = scene.triangles[cell.triangle];
  const triangle_frame f = frame_of(scene, t);
  cell.above = squared_tangent_above(f, along_sides(f, net, piece.is_rational));
  for (std::size_t k = 0; k < 4 && std::isinf(cell.above); ++k) {
    const auto side = static_cast<piece_side>(k);
    const auto stands_there = [&](const parameter_corner& c) { return is_at(c, side); };
    if (!piece.is_point[k] || std::none_of(cell.corners.begin(), cell.corners.end(), stands_there))
      continue;
    const auto q = from_one_point(f, turned(piece, side), turned(cell.corners, side),
                                  piece.point[k], piece.is_rational);
    cell.above = squared_tangent_above(f, q);
  }
  // In the middle, in doubles.
  const auto middle = [&](const auto& of) {
    return (middle_of(of(0)) + middle_of(of(1)) + middle_of(of(2))) / 3;
  };
  const plain_jet jet = evaluate(piece, middle([&](std::size_t k) { return cell.corners[k].s; }),
                                 middle([&](std::size_t k) { return cell.corners[k].t; }));
  const plain_vector normal = cross(jet.by_s, jet.by_t), own = middle_of(f.normal);
  const plain_vector across = cross(normal, own);
  const double along = dot(normal, own);
  cell.below = along > 0 ? dot(across, across) / (along * along) : -1;  // folded
}

}  // namespace asterism::internal
