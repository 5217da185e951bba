// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "asterism/mesh/surface_audit/lifted_bounds.hpp"

namespace asterism::internal {
namespace {

surface_place place_of(const lifted_cell& cell, const parameter_corner& at) {
  return {cell.piece, std::clamp(middle_of(at.s), 0.0, 1.0), std::clamp(middle_of(at.t), 0.0, 1.0)};
}

// A part of a triangle may lie beside it, and a collapsed one is none of the mesh: others are near.
double hull_above(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net,
                  const plain_vector& middle) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const auto points = euclidean(net.points.data(), net.points.size(), piece.is_rational);
  const bool collapsed = scene.triangles[cell.triangle].collapsed;
  if (collapsed || cell.depth > 0)
    cell.hint = nearest_triangle_to(scene.space, middle, cell.hint).triangle;
  const hull_distance own = hull_distance_above(points, scene.space.triangle(cell.hint));
  if (cell.depth == 0 && !collapsed) return own.squared;
  const nearest_triangle other =
      nearest_triangle_to(scene.space, middle_of(points[own.farthest]), cell.hint);
  if (other.triangle == cell.hint) return own.squared;
  const auto two = joined_triangles(scene.space, cell.hint, other.triangle);
  return two ? std::min(own.squared, hull_distance_above(points, *two)) : own.squared;
}

}  // namespace

[[gnu::noinline]] void look_at_distance(const lifted_scene& scene, lifted_cell& cell) {
  const bezier_piece& piece = scene.space.pieces[cell.piece];
  const triangle_net net = net_over(tensor_of(piece), cell.parameters(), piece.is_rational);
  const surface_place at =
      place_of(cell, {(rounded_interval(1.0 / 3)) *
                          (cell.corners[0].at.s + cell.corners[1].at.s + cell.corners[2].at.s),
                      (rounded_interval(1.0 / 3)) *
                          (cell.corners[0].at.t + cell.corners[1].at.t + cell.corners[2].at.t)});
  const plain_vector on_surface = evaluate(piece, at.s, at.t).at;
  cell.above = hull_above(scene, cell, net, on_surface);
  cell.below = nearest_triangle_to(scene.space, on_surface, cell.hint).squared_distance;
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
  const triangle_net net = net_over(tensor_of(piece), {at, at, at}, piece.is_rational);
  const weighted_point& p = net.points[0];
  const rounded_interval far =
      squared_length(p.at - p.weight * vector_of<rounded_interval>(vertex));
  return quotient(far, squared(p.weight)).sup();
}

}  // namespace asterism::internal
