// SPDX-License-Identifier: MIT
//
// Bounds the distance from the mesh to the surface: cells are parts of triangles, each compared
// with the piece of the surface over a triangle of parameters, whose corners are proposed by
// projection.
#include "asterism/mesh/surface_audit/mesh_to_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/witness_proofs.hpp"

namespace asterism::internal {
namespace {

struct mesh_cell {
  std::uint32_t triangle = 0;
  interval_triangle corners;
  surface_place at;                 // of its middle, about nearest
  std::array<surface_place, 3> of;  // of its corners, in the same piece
  double above = 0, below = 0;

  plain_vector corner(std::size_t k) const { return middle_of(corners[k]); }
  plain_vector middle() const { return (1.0 / 3) * (corner(0) + corner(1) + corner(2)); }
};

bool is_at_end(const surface_place& at) { return at.s <= 0 || at.s >= 1 || at.t <= 0 || at.t >= 1; }

parameter_corner corner_at(const surface_place& p) { return {p.s, p.t}; }

double gap_above(const deviation_scene& scene, const held_triangle& held, const mesh_cell& cell) {
  const bezier_piece& piece = scene.pieces[held.piece];
  const triangle_net net = net_over(tensor_of(piece), held.corners, piece.is_rational);
  return squared_gap_above(net, piece.is_rational, cell.corners);
}

// Returns a bound of the squared distance to places that certainly belong to the surface: the
// nearest places may be beyond the trims.
double gap_within_trims(const deviation_scene& scene, const mesh_cell& cell) {
  const trim_scene& trims = *scene.trims;
  const plain_triangle whole = scene.triangle(cell.triangle);
  const auto held = places_in_origin(scene.pieces, trims, trims.origins[cell.triangle],
                                     {plain(whole[0]), plain(whole[1]), plain(whole[2])},
                                     {cell.corner(0), cell.corner(1), cell.corner(2)});
  return held ? gap_above(scene, *held, cell) : std::numeric_limits<double>::infinity();
}

// Bounds a cell. `hint` is a place of the surface nearby, or null: then the whole surface is
// searched.
[[gnu::noinline]] void look_at(const deviation_scene& scene, const surface_place* hint,
                               mesh_cell& cell) {
  const plain_vector middle = cell.middle();
  located here =
      hint != nullptr ? project(scene.pieces, *hint, middle) : scene.locator.nearest(middle);
  if (hint != nullptr && is_at_end(here.at)) {
    const located anywhere = scene.locator.nearest(middle);
    if (anywhere.squared_distance < here.squared_distance) here = anywhere;
  }
  cell.at = here.at;
  cell.below = here.squared_distance;
  for (std::size_t k = 0; k < 3; ++k)
    cell.of[k] = project(scene.pieces, here.at, cell.corner(k)).at;
  const held_triangle held{here.at.piece,
                           {corner_at(cell.of[0]), corner_at(cell.of[1]), corner_at(cell.of[2])}};
  const bool on_surface =
      scene.trims == nullptr || is_on_surface(scene.pieces, *scene.trims, cell.of);
  cell.above = on_surface ? gap_above(scene, held, cell) : gap_within_trims(scene, cell);
}

interval_vector point_between(const interval_vector& a, const interval_vector& b, double share) {
  return a + rounded_interval(share) * (b - a);
}

// Returns how far the places nearest to the three corners are beyond one side of the piece, in its
// parameters; negative inside. Takes, of the sides that some corner is beyond and some other is
// not, the one with the greatest excess. Returns three zeros if there is no such side, or if nearly
// all of the cell is on one side of it.
std::array<double, 3> excesses(const deviation_scene& scene, const mesh_cell& cell) {
  constexpr double reach = 1;
  std::array<surface_place, 3> at;
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = project(scene.pieces, cell.of[k], cell.corner(k), reach).at;
  std::array<double, 3> found{};
  double most = 0;
  for (int side = 0; side < 4; ++side) {
    std::array<double, 3> by;
    for (std::size_t k = 0; k < 3; ++k)
      by[k] = side == 0 ? -at[k].s : side == 1 ? at[k].s - 1 : side == 2 ? -at[k].t : at[k].t - 1;
    const double high = std::max({by[0], by[1], by[2]}), low = std::min({by[0], by[1], by[2]});
    if (low < 0 && high > most) most = high, found = by;
  }
  // Returns three zeros if the side cuts off less than 2 % of the range of excesses: the caller
  // then halves the cell, which is better than a cut there.
  const double high = std::max({found[0], found[1], found[2]});
  const double low = std::min({found[0], found[1], found[2]});
  if (!(high > 0.02 * (high - low) && -low > 0.02 * (high - low))) return {};
  return found;
}

// Divides the triangle along a line near which it crosses a side of the piece. `by` is how far each
// corner is beyond that side.
std::vector<interval_triangle> parted(const mesh_cell& cell, const std::array<double, 3>& by) {
  std::size_t lone = 0;  // the corner alone on its side
  for (std::size_t k = 0; k < 3; ++k)
    if ((by[k] > 0) != (by[(k + 1) % 3] > 0) && (by[k] > 0) != (by[(k + 2) % 3] > 0)) lone = k;
  const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
  const auto share = [&](std::size_t to) {
    return std::clamp(by[lone] / (by[lone] - by[to]), 0.01, 0.99);
  };
  const interval_vector &a = cell.corners[lone], &b = cell.corners[next], &c = cell.corners[last];
  const interval_vector p = point_between(a, b, share(next)), q = point_between(a, c, share(last));
  return {{a, p, q}, {p, b, c}, {p, c, q}};
}

std::vector<interval_triangle> quartered(const interval_triangle& t) {
  const interval_vector p = point_between(t[0], t[1], 0.5), q = point_between(t[1], t[2], 0.5),
                        r = point_between(t[2], t[0], 0.5);
  return {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}};
}

[[gnu::noinline]] std::vector<mesh_cell> parts_of(const deviation_scene& scene,
                                                  const mesh_cell& cell) {
  const std::array<double, 3> by = excesses(scene, cell);
  const bool crosses = by[0] != 0 || by[1] != 0 || by[2] != 0;
  std::vector<mesh_cell> parts;
  for (const interval_triangle& corners : crosses ? parted(cell, by) : quartered(cell.corners)) {
    mesh_cell part{cell.triangle, corners, {}, {}, 0, 0};
    look_at(scene, &cell.at, part);
    part.above = std::min(part.above, cell.above);
    parts.push_back(part);
  }
  return parts;
}

std::vector<mesh_cell> divided(const deviation_scene& scene, const mesh_cell& cell) {
  const floating_point_scope scope(rounding::upward);
  return parts_of(scene, cell);
}

mesh_cell whole_triangle(const deviation_scene& scene, std::uint32_t t) {
  const floating_point_scope scope(rounding::upward);
  const plain_triangle corners = scene.triangle(t);
  mesh_cell cell;
  cell.triangle = t;
  for (std::size_t k = 0; k < 3; ++k) cell.corners[k] = vector_of<rounded_interval>(corners[k]);
  look_at(scene, scene.places != nullptr ? &(*scene.places)[t] : nullptr, cell);
  return cell;
}

std::vector<mesh_cell> whole_triangles(const deviation_scene& scene) {
  std::vector<mesh_cell> cells(scene.mesh.triangles.size());
  parallel_for(cells.size(), [&](std::size_t t) {
    cells[t] = whole_triangle(scene, static_cast<std::uint32_t>(t));
  });
  return cells;
}

// Searches the whole surface for the nearest place of the cell's middle: the projection from a
// place nearby may have ended at another place that is nearest only locally, for instance beyond a
// blunt edge.
void confirm(const deviation_scene& scene, mesh_cell& cell) {
  const floating_point_scope scope(rounding::upward);
  const located anywhere = scene.locator.nearest(cell.middle());
  if (anywhere.squared_distance < cell.below)
    cell.at = anywhere.at, cell.below = anywhere.squared_distance;
}

narrowed<mesh_cell> narrowed_mesh(const deviation_scene& scene, std::vector<mesh_cell> cells,
                                  const narrowing_limits& limits) {
  return narrow(
      std::move(cells), limits, [&](const mesh_cell& cell) { return divided(scene, cell); },
      [](const mesh_cell&) {}, [&](mesh_cell& cell) { confirm(scene, cell); });
}

double root_above(const narrowed<mesh_cell>& found) {
  const floating_point_scope scope(rounding::upward);
  return rounded_root(found.above);
}

}  // namespace

double distance_of_mesh(const deviation_scene& scene, const narrowing_limits& limits) {
  return root_above(narrowed_mesh(scene, whole_triangles(scene), limits));
}

double distance_of_triangle(const deviation_scene& scene, std::uint32_t triangle,
                            const narrowing_limits& limits) {
  return root_above(narrowed_mesh(scene, {whole_triangle(scene, triangle)}, limits));
}

one_sided_distance from_mesh(const deviation_scene& scene, const narrowing_limits& limits) {
  const auto found = narrowed_mesh(scene, whole_triangles(scene), limits);
  one_sided_distance answer;
  answer.cells = found.cells;
  answer.narrowed = found.done;
  answer.high = root_above(found);
  const floating_point_scope scope(rounding::upward);
  const plain_vector middle = found.best->middle();
  const triangle_place place = nearest_in(scene.triangle(found.best->triangle), middle).at;
  answer.witness = {true, found.best->triangle, place.s, place.t, {middle.x, middle.y, middle.z}};
  const double proposed = rounded_root(found.best->below);
  if (proposed > limits.negligible)
    answer.low = proved_distance_of_mesh_point(scene, answer.witness, proposed);
  return answer;
}

}  // namespace asterism::internal
