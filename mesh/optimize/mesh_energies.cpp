// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/mesh_energies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::fitting {
namespace {

// Degrees above the bound below which the energy is steeper (docs/design/fitting.md).
constexpr double degrees_to_spare = 0.5;

double cotangent(double degrees) { return 1 / elementary::tan(degrees * std::numbers::pi / 180); }

}  // namespace

mesh_energies::mesh_energies(const mutable_triangulation& net, double angle_bound,
                             double target_angle)
    : wanted_{cotangent(target_angle),
              cotangent(std::min(target_angle, angle_bound + degrees_to_spare))},
      corners_(net, angle_bound) {
  for (vertex_index t = 0; t < net.triangles().size(); ++t) judge(net, t);
}

void mesh_energies::judge_stars(const mutable_triangulation& net, bool yes) {
  judges_stars_ = yes;
  for (vertex_index t = 0; t < net.triangles().size(); ++t)
    if (net.triangles()[t].exists()) judge_again(net, t);
}

void mesh_energies::judge_again(const mutable_triangulation& net, vertex_index t) {
  changed_[t] = 1;
  shapes_[t] = shape_now(net, t);
  if (judges_stars_) centres_[t] = centre_now(net, t);
}

double mesh_energies::shape_now(const mutable_triangulation& net, vertex_index t) const {
  const auto& [a, b, c] = net.triangles()[t].v;
  const auto& sites = net.sites();
  return shape_energy(sites[a], sites[b], sites[c], wanted_, sharp_[t] != 0);
}

voronoi_centre mesh_energies::centre_now(const mutable_triangulation& net, vertex_index t) const {
  const auto& [a, b, c] = net.triangles()[t].v;
  const auto& sites = net.sites();
  return find_centre(sites[a], sites[b], sites[c]);
}

void mesh_energies::judge(const mutable_triangulation& net, vertex_index t) {
  if (t >= shapes_.size()) {
    shapes_.resize(t + 1);
    centres_.resize(t + 1);
    sharp_.resize(t + 1);
    changed_.resize(t + 1);
  }
  if (!net.triangles()[t].exists()) {
    shapes_[t] = 0;
    return;
  }
  sharp_[t] = corners_.touch(net, net.triangles()[t].v) ? 1 : 0;
  judge_again(net, t);
}

void mesh_energies::truncate(std::size_t count) {
  if (count >= shapes_.size()) return;
  shapes_.resize(count);
  centres_.resize(count);
  sharp_.resize(count);
  changed_.resize(count);
}

double mesh_energies::shape_of(const mutable_triangulation& net,
                               const std::array<vertex_index, 3>& v) const {
  const auto& sites = net.sites();
  return shape_energy(sites[v[0]], sites[v[1]], sites[v[2]], wanted_, corners_.touch(net, v));
}

// Returns the energy of an edge as the centre of t sees it. A subsegment at a sharp corner counts
// nothing: it cannot have the centre on its inner side, and need not.
double mesh_energies::of_edge(const mutable_triangulation& net, vertex_index t,
                              std::size_t edge) const {
  const fit_triangle& here = net.triangles()[t];
  const auto& sites = net.sites();
  if (here.segment[edge] != none && sharp_[t] != 0) return 0;
  if (here.segment[edge] != none)
    return subsegment_energy(centres_[t], sites[here.v[(edge + 1) % 3]].position,
                             sites[here.v[(edge + 2) % 3]].position, sites[here.v[edge]].position);
  return far_site_energy(centres_[t], sites[net.far_vertex(t, edge)]);
}

double mesh_energies::of_edges(const mutable_triangulation& net, vertex_index t) const {
  if (!judges_stars_) return 0;
  return of_edge(net, t, 0) + of_edge(net, t, 1) + of_edge(net, t, 2);
}

double mesh_energies::of_triangle(const mutable_triangulation& net, vertex_index t) const {
  return shapes_[t] + of_edges(net, t);
}

double mesh_energies::around(const mutable_triangulation& net, vertex_index v) const {
  double sum = 0;
  for (const vertex_index t : net.around(v)) sum += shapes_[t];
  if (!judges_stars_) return sum;
  for (const vertex_index t : net.around(v)) {
    sum += of_edges(net, t);
    const fit_triangle& here = net.triangles()[t];
    const std::size_t i = here.corner_of(v);
    if (here.segment[i] != none) continue;
    sum += far_site_energy(centres_[here.next[i]], net.sites()[v]);
  }
  return sum;
}

double mesh_energies::of_edges_of_pair(const mutable_triangulation& net, vertex_index t,
                                       vertex_index s) const {
  if (!judges_stars_) return 0;
  double sum = of_edges(net, t) + of_edges(net, s);
  for (const auto& [here, other] : {std::pair{t, s}, std::pair{s, t}})
    for (std::size_t i = 0; i < 3; ++i) {
      const fit_triangle& from = net.triangles()[here];
      if (from.segment[i] != none || from.next[i] == other) continue;
      sum += far_site_energy(centres_[from.next[i]], net.sites()[from.v[i]]);
    }
  return sum;
}

// Judges shapes first: they cost less than centres, and most trials fail by them.
double mesh_energies::try_around(const mutable_triangulation& net, vertex_index v, double below) {
  const std::vector<vertex_index>& triangles = net.around(v);
  old_shapes_.clear();
  old_centres_.clear();
  double sum = 0;
  for (const vertex_index t : triangles) {
    old_shapes_.push_back(std::exchange(shapes_[t], shape_now(net, t)));
    sum += shapes_[t];
    if (!(sum < below)) return sum;
  }
  if (!judges_stars_) return sum;
  for (const vertex_index t : triangles)
    old_centres_.push_back(std::exchange(centres_[t], centre_now(net, t)));
  return around(net, v);
}

void mesh_energies::restore_around(const mutable_triangulation& net, vertex_index v) {
  const std::vector<vertex_index>& triangles = net.around(v);
  for (std::size_t i = 0; i < old_shapes_.size(); ++i) shapes_[triangles[i]] = old_shapes_[i];
  for (std::size_t i = 0; i < old_centres_.size(); ++i) centres_[triangles[i]] = old_centres_[i];
}

}  // namespace asterism::internal::fitting
