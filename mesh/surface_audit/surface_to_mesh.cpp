// SPDX-License-Identifier: MIT
//
// Bounds the distance from the surface to the mesh: cells are boxes of a piece's parameters with
// their control points, halved by de Casteljau's algorithm.
#include "asterism/mesh/surface_audit/surface_to_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/net_halving.hpp"
#include "asterism/mesh/surface_audit/witness_proofs.hpp"

namespace asterism::internal {
namespace {

struct surface_cell {
  std::uint32_t piece = 0;
  double s_low = 0, s_high = 1, t_low = 0, t_high = 1;
  std::vector<weighted_point> net;
  std::uint32_t hint = 0;  // a triangle nearby
  double above = 0, below = 0;

  double s() const { return (s_low + s_high) / 2; }
  double t() const { return (t_low + t_high) / 2; }
};

[[gnu::noinline]] void look_at(const deviation_scene& scene, surface_cell& cell) {
  const bezier_piece& piece = scene.pieces[cell.piece];
  const plain_vector middle = evaluate(piece, cell.s(), cell.t()).at;
  const nearest_triangle near = nearest_triangle_to(scene, middle, cell.hint);
  cell.hint = near.triangle;
  cell.below = near.squared_distance;
  const auto points = euclidean(cell.net.data(), cell.net.size(), piece.is_rational);
  const hull_distance own = hull_distance_above(points, scene.triangle(near.triangle));
  cell.above = own.squared;
  const plain_vector far = middle_of(points[own.farthest]);
  const nearest_triangle other = nearest_triangle_to(scene, far, near.triangle);
  if (other.triangle == near.triangle) return;
  if (const auto two = joined_triangles(scene, near.triangle, other.triangle))
    cell.above = std::min(cell.above, hull_distance_above(points, *two));
}

[[gnu::noinline]] std::array<surface_cell, 2> halves(const deviation_scene& scene,
                                                     const surface_cell& cell) {
  const std::size_t row = scene.pieces[cell.piece].row();
  const bool by_s = is_longer_by_s(cell.net, row);
  auto nets = halved(cell.net, row, by_s);
  std::array<surface_cell, 2> parts = {cell, cell};
  parts[0].net = std::move(nets[0]), parts[1].net = std::move(nets[1]);
  if (by_s)
    parts[0].s_high = parts[1].s_low = cell.s();
  else
    parts[0].t_high = parts[1].t_low = cell.t();
  for (surface_cell& part : parts) {
    look_at(scene, part);
    part.above = std::min(part.above, cell.above);
  }
  return parts;
}

std::vector<surface_cell> divided(const deviation_scene& scene, const surface_cell& cell) {
  const floating_point_scope scope(rounding::upward);
  auto parts = halves(scene, cell);
  return {std::move(parts[0]), std::move(parts[1])};
}

std::vector<surface_cell> whole_pieces(const deviation_scene& scene) {
  std::vector<surface_cell> cells(scene.pieces.size());
  const floating_point_scope scope(rounding::upward);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k].piece = static_cast<std::uint32_t>(k);
    cells[k].net = scene.pieces[k].net;
    look_at(scene, cells[k]);
  }
  return cells;
}

}  // namespace

nearest_triangle nearest_triangle_to(const deviation_scene& scene, const plain_vector& p,
                                     std::uint32_t hint) {
  nearest_triangle best{hint, nearest_in(scene.triangle(hint), p).squared_distance};
  scene.triangles.visit_near(
      p, [&] { return best.squared_distance; },
      [&](std::uint32_t t) {
        if (t == hint) return;
        const double far = nearest_in(scene.triangle(t), p).squared_distance;
        if (far < best.squared_distance) best = {t, far};
      });
  return best;
}

std::optional<two_triangles> joined_triangles(const deviation_scene& scene, std::uint32_t a,
                                              std::uint32_t b) {
  const space_triangle& first = scene.mesh.triangles[a];
  const space_triangle& second = scene.mesh.triangles[b];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto at = [&](const space_triangle& t, std::size_t k) {
        return scene.mesh.points[t[k % 3]];
      };
      const space_point p = at(first, i), q = at(first, i + 1), u = at(second, j),
                        v = at(second, j + 1);
      if ((p == v && q == u) || (p == u && q == v))
        return two_triangles{{p, q}, at(first, i + 2), at(second, j + 2)};
    }
  return std::nullopt;
}

one_sided_distance from_surface(const deviation_scene& scene, const narrowing_limits& limits) {
  const auto found = narrow(whole_pieces(scene), limits,
                            [&](const surface_cell& cell) { return divided(scene, cell); });
  one_sided_distance answer;
  answer.cells = found.cells;
  answer.narrowed = found.done;
  const floating_point_scope scope(rounding::upward);
  answer.high = rounded_root(found.above);
  const surface_cell& best = *found.best;
  const bezier_piece& piece = scene.pieces[best.piece];
  const plain_vector at = evaluate(piece, best.s(), best.t()).at;
  const double proposed = rounded_root(best.below);
  if (proposed > limits.negligible)
    answer.low =
        proved_distance_of_surface_point(scene, {best.piece, best.s(), best.t()}, proposed);
  answer.witness = {false,
                    piece.patch,
                    piece.u_low + best.s() * (piece.u_high - piece.u_low),
                    piece.v_low + best.t() * (piece.v_high - piece.v_low),
                    {at.x, at.y, at.z}};
  return answer;
}

}  // namespace asterism::internal
