// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/lifted_cells.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

// A corner of a part, by its place in the patch. On a cut its parameter is the knot itself, which
// is exact.
struct cut_corner {
  std::array<rounded_interval, 2> at;
};
using cut_polygon = std::vector<cut_corner>;

rounded_interval between(const rounded_interval& a, const rounded_interval& b,
                         const rounded_interval& share) {
  return a + share * (b - a);
}

// Returns the point where a side crosses a knot. Requires corners strictly on different sides of
// it.
cut_corner crossing(const cut_corner& p, const cut_corner& q, std::size_t axis, double knot) {
  const rounded_interval from = rounded_interval(knot) - p.at[axis], to = q.at[axis] - p.at[axis];
  const rounded_interval share = to.inf() > 0 ? quotient(from, to) : quotient(-from, -to);
  cut_corner c;
  for (std::size_t k = 0; k < 2; ++k) c.at[k] = between(p.at[k], q.at[k], share);
  c.at[axis] = knot;
  return c;
}

// True if it is not certain on which side of the knot some corner is: corners on a cut along the
// other axis are intervals.
bool is_uncertain(const cut_polygon& p, std::size_t axis, double knot) {
  return std::any_of(p.begin(), p.end(), [&](const cut_corner& c) {
    const rounded_interval& x = c.at[axis];
    return x.inf() <= knot && knot <= x.sup() && x.inf() < x.sup();
  });
}

// Returns the part on one side of a knot: below it, or above.
cut_polygon part_of(const cut_polygon& from, std::size_t axis, double knot, bool below) {
  const auto side = [&](const cut_corner& c) {
    if (c.at[axis].sup() < knot) return below ? 1 : -1;
    if (c.at[axis].inf() > knot) return below ? -1 : 1;
    return 0;
  };
  cut_polygon to;
  for (std::size_t k = 0; k < from.size(); ++k) {
    const cut_corner &p = from[k], &q = from[(k + 1) % from.size()];
    if (side(p) >= 0) to.push_back(p);
    if (side(p) * side(q) < 0) to.push_back(crossing(p, q, axis, knot));
  }
  return to;
}

double lowest(const cut_polygon& p, std::size_t axis) {
  double low = p[0].at[axis].inf();
  for (const cut_corner& c : p) low = std::min(low, c.at[axis].inf());
  return low;
}

double highest(const cut_polygon& p, std::size_t axis) {
  double high = p[0].at[axis].sup();
  for (const cut_corner& c : p) high = std::max(high, c.at[axis].sup());
  return high;
}

// Cuts a polygon into its parts in the spans; calls take(part, number of the span). Returns false
// if the side of a corner is not certain.
template <class Take>
bool cut(cut_polygon polygon, std::size_t axis, const std::vector<double>& ends, const Take& take) {
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const bool last = k + 2 == ends.size();
    if (polygon.size() < 3) return true;
    if (!last && is_uncertain(polygon, axis, ends[k + 1])) return false;
    if (!last && lowest(polygon, axis) >= ends[k + 1]) continue;
    if (last || highest(polygon, axis) <= ends[k + 1]) {
      take(polygon, k);
      return true;
    }
    const cut_polygon below = part_of(polygon, axis, ends[k + 1], true);
    if (below.size() >= 3) take(below, k);
    polygon = part_of(polygon, axis, ends[k + 1], false);
  }
  return true;
}

rounded_interval local(const rounded_interval& x, double low, double high) {
  if (x.inf() == high && x.sup() == high) return 1;
  const rounded_interval from = low;
  return quotient(x - from, rounded_interval(high) - from);
}

parameter_corner corner_in(const cut_corner& c, const bezier_piece& piece) {
  return {local(c.at[0], piece.u_low, piece.u_high), local(c.at[1], piece.v_low, piece.v_high)};
}

rounded_interval half_of(const rounded_interval& a, const rounded_interval& b) {
  return rounded_interval(0.5) * (a + b);
}

parameter_corner middle_of(const parameter_corner& a, const parameter_corner& b) {
  return {half_of(a.s, b.s), half_of(a.t, b.t)};
}

}  // namespace

std::vector<lifted_cell> cells_of(const lifted_scene& scene, std::uint32_t triangle) {
  const shell_triangle& t = scene.triangles[triangle];
  cut_polygon whole(3);
  for (std::size_t k = 0; k < 3; ++k)
    whole[k].at = {rounded_interval(t.at[k][0]), rounded_interval(t.at[k][1])};
  const patch_spans& spans = scene.spans[t.face];
  const auto last = static_cast<std::uint32_t>(scene.space.mesh.triangles.size() - 1);
  std::vector<lifted_cell> cells;
  bool certain = true;
  const bool across = cut(whole, 0, spans.u, [&](const cut_polygon& strip, std::size_t i) {
    certain &= cut(strip, 1, spans.v, [&](const cut_polygon& part, std::size_t j) {
      const auto piece = static_cast<std::uint32_t>(spans.first + i * (spans.v.size() - 1) + j);
      for (std::size_t k = 2; k < part.size(); ++k) {
        lifted_cell cell;
        cell.triangle = triangle, cell.piece = piece, cell.hint = std::min(t.kept, last);
        const std::array<std::size_t, 3> fan = {0, k - 1, k};
        for (std::size_t c = 0; c < 3; ++c)
          cell.corners[c] = corner_in(part[fan[c]], scene.space.pieces[piece]);
        cells.push_back(cell);
      }
    });
  });
  if (!certain || !across) cells.clear();
  for (lifted_cell& cell : cells) cell.is_cut = cells.size() > 1;
  return cells;
}

std::array<lifted_cell, 4> quarters(const lifted_cell& cell) {
  const auto& [a, b, c] = cell.corners;
  const parameter_corner p = middle_of(a, b), q = middle_of(b, c), r = middle_of(c, a);
  std::array<lifted_cell, 4> parts = {cell, cell, cell, cell};
  parts[0].corners = {a, p, r};
  parts[1].corners = {p, b, q};
  parts[2].corners = {r, q, c};
  parts[3].corners = {p, q, r};
  for (lifted_cell& part : parts) ++part.depth;
  return parts;
}

triangle_net net_of(const lifted_scene& scene, const lifted_cell& cell) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  return net_over(tensor_of(piece), cell.corners, piece.is_rational);
}

}  // namespace asterism::internal
