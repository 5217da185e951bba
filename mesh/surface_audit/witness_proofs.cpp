// SPDX-License-Identifier: MIT
// Proves that a witness has at least its distance: by hulls of control points that lie on the far
// side of a plane, and by triangles that are all farther.
#include "asterism/mesh/surface_audit/witness_proofs.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/net_halving.hpp"

namespace asterism::internal {
namespace {

// Factors of the proposed distance that are tried, in order: the proposal is rounded.
constexpr std::array<double, 5> shares = {1 - 0x1p-48, 1 - 1e-12, 1 - 1e-9, 1 - 1e-6, 1 - 1e-3};

// Returns the point of a Bezier curve, by de Casteljau's algorithm.
exact_weighted_point along(std::vector<exact_weighted_point> c, const dyadic& share) {
  for (std::size_t left = c.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k) c[k] = mixed(c[k], c[k + 1], share);
  return c[0];
}

// Returns the point of a Bezier patch exactly; none of a patch with inner knots.
std::optional<exact_weighted_point> exact_at(const surface_patch& p, double s, double t) {
  const auto is_bezier = [](std::size_t count, int degree) {
    return count == static_cast<std::size_t>(degree) + 1;
  };
  if (!is_bezier(p.count_u, p.degree_u) || !is_bezier(p.count_v, p.degree_v)) return std::nullopt;
  std::vector<exact_weighted_point> column;
  for (std::size_t i = 0; i < p.count_u; ++i) {
    std::vector<exact_weighted_point> row;
    for (std::size_t j = 0; j < p.count_v; ++j) {
      const dyadic w = p.at(i, j).weight;
      row.push_back({w * vector_of<dyadic>(p.at(i, j).at), w});
    }
    column.push_back(along(std::move(row), t));
  }
  return along(std::move(column), s);
}

struct surface_point_proof {
  const deviation_scene& scene;
  weighted_point enclosed;
  std::optional<exact_weighted_point> exact;
  plain_vector about;

  bool holds(double distance) const;
  bool is_beyond(const plain_triangle& t, double distance) const {
    const rounded_interval bound = distance;
    if (is_farther(enclosed.at, enclosed.weight, t, squared(bound))) return true;
    if (!exact) return false;
    const dyadic exact_bound = distance;
    return is_farther(exact->at, exact->weight, t, exact_bound * exact_bound);
  }
};

bool surface_point_proof::holds(double distance) const {
  bool all = true;
  // Tests boxes a little beyond the distance too, which allows for the rounding of their distances.
  const double limit = 1.01 * distance * distance;
  scene.triangles.visit_near(
      about, [&] { return all ? limit : -1.0; },
      [&](std::uint32_t t) { all = all && is_beyond(scene.triangle(t), distance); });
  return all;
}

// A part of a piece, with the control points over it.
struct far_cell {
  std::uint32_t piece = 0;
  control_net net;
};

// True if the hull is certainly farther than the distance from x: beyond a plane across `toward`.
bool is_beyond_plane(const far_cell& cell, const interval_vector& x, const plain_vector& toward,
                     double distance) {
  const interval_vector g{toward.x, toward.y, toward.z};
  const rounded_interval bound =
      root_of_non_negative(squared_length(g)) * rounded_interval(distance);
  return std::all_of(cell.net.begin(), cell.net.end(), [&](const weighted_point& c) {
    return (dot(g, c.at - c.weight * x) - c.weight * bound).inf() > 0;
  });
}

plain_vector middle_of_net(const far_cell& cell) {
  plain_vector sum{0, 0, 0};
  for (const weighted_point& c : cell.net)
    sum =
        sum + (1 / (middle_of(c.weight) * static_cast<double>(cell.net.size()))) * middle_of(c.at);
  return sum;
}

bool is_beyond_surface(const deviation_scene& scene, const interval_vector& x, double distance) {
  constexpr std::size_t most_cells = 100'000;
  std::vector<far_cell> waiting;
  for (std::uint32_t k = 0; k < scene.pieces.size(); ++k)
    waiting.push_back({k, scene.pieces[k].net});
  const plain_vector about = middle_of(x);
  for (std::size_t looked = 0; !waiting.empty(); ++looked) {
    if (looked == most_cells) return false;
    const far_cell cell = std::move(waiting.back());
    waiting.pop_back();
    if (is_beyond_plane(cell, x, middle_of_net(cell) - about, distance)) continue;
    const std::size_t row = scene.pieces[cell.piece].row();
    for (control_net& part : halved(cell.net, row, is_longer_by_s(cell.net, row)))
      waiting.push_back({cell.piece, std::move(part)});
  }
  return true;
}

[[gnu::noinline]] double proved_of_mesh(const deviation_scene& scene, const deviation_witness& at,
                                        double proposed) {
  const plain_triangle corners = scene.triangle(at.of);
  const interval_vector a = vector_of<rounded_interval>(corners[0]);
  const interval_vector x =
      a + rounded_interval(at.first) * (vector_of<rounded_interval>(corners[1]) - a) +
      rounded_interval(at.second) * (vector_of<rounded_interval>(corners[2]) - a);
  for (std::size_t k = 3; k < shares.size(); ++k)
    if (is_beyond_surface(scene, x, shares[k] * proposed)) return shares[k] * proposed;
  return 0;
}

[[gnu::noinline]] double proved_of_surface(const deviation_scene& scene, const surface_place& at,
                                           double proposed) {
  const bezier_piece& piece = scene.pieces[at.piece];
  const parameter_corner corner{at.s, at.t};
  const surface_point_proof proof{scene, point_at(tensor_of(piece), corner, piece.is_rational),
                                  exact_at(scene.of.patches[piece.patch], at.s, at.t),
                                  evaluate(piece, at.s, at.t).at};
  for (const double share : shares)
    if (proof.holds(share * proposed)) return share * proposed;
  return 0;
}

}  // namespace

double proved_distance_of_mesh_point(const deviation_scene& scene, const deviation_witness& at,
                                     double proposed) {
  if (!(proposed > 0)) return 0;
  const floating_point_scope scope(rounding::upward);
  return proved_of_mesh(scene, at, proposed);
}

double proved_distance_of_surface_point(const deviation_scene& scene, const surface_place& at,
                                        double proposed) {
  if (!(proposed > 0)) return 0;
  const floating_point_scope scope(rounding::upward);
  return proved_of_surface(scene, at, proposed);
}

}  // namespace asterism::internal
