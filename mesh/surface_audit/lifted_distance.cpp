// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/lifted_distance.hpp"

#include <algorithm>
#include <optional>

#include "asterism/mesh/surface_audit/surface_to_mesh.hpp"

namespace asterism::internal {
namespace {

surface_place place_of(const lifted_cell& cell, const parameter_corner& at) {
  return {cell.piece, std::clamp(middle_of(at.s), 0.0, 1.0), std::clamp(middle_of(at.t), 0.0, 1.0)};
}

// Bounds the distance of a part from the triangles near it: a part may lie beside its own triangle,
// and a collapsed triangle is not in the mesh. Sets `below`, the squared distance of the middle,
// along with `above`.
void bound_by_hull(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net,
                   const plain_vector& middle) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const auto points = euclidean(net.points.data(), net.points.size(), piece.is_rational);
  const bool whole = cell.depth == 0 && !scene.triangles[cell.triangle].collapsed;
  const nearest_triangle near = nearest_triangle_to(scene.space, middle, cell.hint);
  cell.below = near.squared_distance;
  if (!whole) cell.hint = near.triangle;
  const hull_distance own = hull_distance_above(points, scene.space.triangle(cell.hint));
  cell.above = own.squared;
  if (whole) return;
  const nearest_triangle other =
      nearest_triangle_to(scene.space, middle_of(points[own.farthest]), cell.hint);
  if (other.triangle == cell.hint) return;
  if (const auto two = joined_triangles(scene.space, cell.hint, other.triangle))
    cell.above = std::min(cell.above, hull_distance_above(points, *two));
}

}  // namespace

[[gnu::noinline]] void look_at_distance(const lifted_scene& scene, lifted_cell& cell,
                                        const triangle_net& net) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const auto& [a, b, c] = cell.corners;
  const rounded_interval third = 1.0 / 3;
  const surface_place at = place_of(cell, {third * (a.s + b.s + c.s), third * (a.t + b.t + c.t)});
  bound_by_hull(scene, cell, net, evaluate(piece, at.s, at.t).at);
}

double squared_vertex_distance(const lifted_scene& scene, std::uint32_t face, double u, double v,
                               const space_point& vertex) {
  const bezier_piece& piece =
      scene.space.pieces[place_in(scene.space.pieces, scene.spans[face], u, v).piece];
  const auto local = [](double x, double low, double high) {
    const rounded_interval from = low;
    return quotient(rounded_interval(x) - from, rounded_interval(high) - from);
  };
  const parameter_corner at{local(u, piece.u_low, piece.u_high),
                            local(v, piece.v_low, piece.v_high)};
  const weighted_point p = point_at(tensor_of(piece), at, piece.is_rational);
  const rounded_interval far =
      squared_length(p.at - p.weight * vector_of<rounded_interval>(vertex));
  return quotient(far, squared(p.weight)).sup();
}

}  // namespace asterism::internal
