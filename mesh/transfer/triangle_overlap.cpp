// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/triangle_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

int value_of(sign s) { return s == sign::positive ? 1 : s == sign::negative ? -1 : 0; }

double doubled(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A corner of the polygon while it is being clipped: a corner of the old triangle, one of the new,
// or where an edge of the old one crosses a line of the new one.
struct symbol {
  enum class kind { old_corner, new_corner, crossing } what = kind::old_corner;
  std::size_t old_index = 0, new_index = 0;  // corners, or edges of a crossing
};

// Line of an edge of the polygon: of the old or the new triangle.
struct carrier {
  bool of_new = false;
  std::size_t edge = 0;
};

struct polygon {
  std::array<std::pair<symbol, carrier>, 12> at;  // a corner, and the line of the edge after it
  std::size_t count = 0;
  void add(const symbol& s, const carrier& c) { at[count++] = {s, c}; }
};

// Returns on which side of line j of the new triangle the corner is: 1 inside, 0 on it, -1 outside.
int side_of(const symbol& s, std::size_t j, const overlap_signs& signs) {
  if (s.what == symbol::kind::old_corner) return value_of(signs.old_against[j][s.old_index]);
  if (s.what == symbol::kind::new_corner) return j == next(s.new_index) ? 1 : 0;
  if (s.new_index == j) return 0;
  // Decides the side by orientations: the crossing is on line m, which shares a corner with line j.
  // Along m the orientation against the old edge changes its sign at the crossing, to positive if
  // that edge leads from inside of m to outside; so its sign at the shared corner shows on which
  // side of the crossing that corner is.
  const std::size_t m = s.new_index;
  const bool ends_at_j = j == next(m);
  const std::size_t shared = ends_at_j ? j : m;
  const int direction = value_of(signs.old_against[m][s.old_index]) > 0 ? 1 : -1;
  const int after = direction * value_of(signs.new_against[s.old_index][shared]);
  return ends_at_j ? after : -after;
}

symbol meet(const carrier& line, std::size_t j) {
  if (!line.of_new) return {symbol::kind::crossing, line.edge, j};
  // Takes the corner that edges `line` and j of the new triangle share: the start of the one that
  // follows the other.
  return {symbol::kind::new_corner, 0, j == next(line.edge) ? j : line.edge};
}

polygon clipped(const polygon& p, std::size_t j, const overlap_signs& signs) {
  polygon out;
  for (std::size_t i = 0; i < p.count; ++i) {
    const auto& [corner, line] = p.at[i];
    const int here = side_of(corner, j, signs),
              there = side_of(p.at[i + 1 == p.count ? 0 : i + 1].first, j, signs);
    const carrier cut{true, j};
    if (here >= 0) {
      out.add(corner, here == 0 && there < 0 ? cut : line);
      if (here > 0 && there < 0) out.add(meet(line, j), cut);
    } else if (there > 0) {
      out.add(meet(line, j), line);
    }
  }
  return out;
}

// An edge, directed from its end with the lesser number. Crossings are measured from that end, so
// that both triangles at the edge compute the same ones.
struct ordered_edge {
  std::size_t low, high;  // corners of the triangle
  explicit ordered_edge(const triangle& v, std::size_t edge)
      : low(v[edge] < v[next(edge)] ? edge : next(edge)), high(low == edge ? next(edge) : edge) {}
};

// Returns the parameter at which the line of another edge crosses an edge, from its lesser end.
double part_along(const numbered_triangle& t, const ordered_edge& e, const numbered_triangle& other,
                  const ordered_edge& line) {
  const point &p = other.at[line.low], &q = other.at[line.high];
  const double a = std::abs(doubled(p, q, t.at[e.low])), b = std::abs(doubled(p, q, t.at[e.high]));
  return a + b > 0 ? a / (a + b) : 0.5;
}

// Returns the parameter of the foot of a point on an edge: 0 at the end with the lesser number, 1
// at the other end.
double foot_along(const numbered_triangle& t, const ordered_edge& e, const point& at) {
  const point &a = t.at[e.low], &b = t.at[e.high];
  const double x = b.x - a.x, y = b.y - a.y;
  return ((at.x - a.x) * x + (at.y - a.y) * y) / (x * x + y * y);
}

point point_along(const numbered_triangle& t, const ordered_edge& e, double part) {
  const point &a = t.at[e.low], &b = t.at[e.high];
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

// Sets one place in both triangles. For edges that nearly lie on one line, doubles do not determine
// where they cross: a parameter computed for each edge by itself would name two places, and the
// shape functions of one would be integrated with the values at the other.
void set_crossing(const numbered_triangle& old_one, const numbered_triangle& new_one,
                  const symbol& s, overlap_corner& made) {
  const ordered_edge old_edge(old_one.v, s.old_index), new_edge(new_one.v, s.new_index);
  double t = part_along(old_one, old_edge, new_one, new_edge);
  made.at = point_along(old_one, old_edge, t);
  const double foot = foot_along(new_one, new_edge, made.at), u = std::clamp(foot, 0.0, 1.0);
  if (u != foot) {  // beyond the new edge, so that its end is nearer to the crossing
    made.at = point_along(new_one, new_edge, u);
    t = std::clamp(foot_along(old_one, old_edge, made.at), 0.0, 1.0);
  }
  made.in_old[old_edge.low] = 1 - t;
  made.in_old[old_edge.high] = t;
  made.in_new[new_edge.low] = 1 - u;
  made.in_new[new_edge.high] = u;
}

// Returns the corner that a crossing is, if one end of the new edge is on the line of the old edge.
// Doubles do not determine that place where the two edges nearly lie on one line.
symbol exact(const symbol& s, const overlap_signs& signs) {
  if (s.what != symbol::kind::crossing) return s;
  for (const std::size_t end : {s.new_index, next(s.new_index)})
    if (signs.new_against[s.old_index][end] == sign::zero)
      return {symbol::kind::new_corner, 0, end};
  return s;
}

overlap_corner corner_of(const numbered_triangle& old_one, const numbered_triangle& new_one,
                         const symbol& s) {
  overlap_corner made;
  if (s.what == symbol::kind::old_corner) {
    made.at = old_one.at[s.old_index];
    made.in_old[s.old_index] = 1;
    made.in_new = weights_in(new_one.at, made.at);
  } else if (s.what == symbol::kind::new_corner) {
    made.at = new_one.at[s.new_index];
    made.in_new[s.new_index] = 1;
    made.in_old = weights_in(old_one.at, made.at);
  } else {
    set_crossing(old_one, new_one, s, made);
  }
  return made;
}

}  // namespace

std::array<double, 3> weights_in(const std::array<point, 3>& c, const point& q) {
  for (std::size_t i = 0; i < 3; ++i)
    if (c[i] == q) {
      std::array<double, 3> unit{};
      unit[i] = 1;
      return unit;
    }
  std::array<double, 3> w = {std::max(0.0, doubled(q, c[1], c[2])),
                             std::max(0.0, doubled(c[0], q, c[2])),
                             std::max(0.0, doubled(c[0], c[1], q))};
  const double sum = w[0] + w[1] + w[2];
  if (!(sum > 0)) return {1, 0, 0};
  for (double& x : w) x /= sum;
  return w;
}

overlap_signs::overlap_signs(const numbered_triangle& old_one, const numbered_triangle& new_one) {
  const filtered_kernel kernel;
  for (std::size_t e = 0; e < 3; ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      old_against[e][c] = kernel.orientation(new_one.at[e], new_one.at[next(e)], old_one.at[c]);
      new_against[e][c] = kernel.orientation(old_one.at[e], old_one.at[next(e)], new_one.at[c]);
    }
}

bool overlap_signs::goes_on(std::size_t i) const {
  bool beyond = false;
  for (const sign s : new_against[i]) beyond = beyond || s == sign::negative;
  if (!beyond) return false;
  for (const auto& line : old_against)
    if (line[i] != sign::positive && line[next(i)] != sign::positive) return false;
  return true;
}

overlap common_part(const numbered_triangle& old_one, const numbered_triangle& new_one,
                    const overlap_signs& signs) {
  polygon p;
  for (std::size_t i = 0; i < 3; ++i) p.add({symbol::kind::old_corner, i, 0}, {false, i});
  for (std::size_t j = 0; j < 3; ++j) p = clipped(p, j, signs);
  overlap made;
  if (p.count < 3) return made;
  made.count = std::min(p.count, made.corners.size());
  for (std::size_t i = 0; i < made.count; ++i)
    made.corners[i] = corner_of(old_one, new_one, exact(p.at[i].first, signs));
  return made;
}

}  // namespace asterism::internal
