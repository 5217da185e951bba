// SPDX-License-Identifier: MIT
//
// Improves a mesh in the metric of its nodes: fewer nodes, better shapes.
#include <algorithm>
#include <utility>

#include "asterism/mesh/adapt/unit_mesh.hpp"

namespace asterism::internal::adapting {

namespace {

// Energy by which the sum after a merge may exceed the one for an unchanged mean: flips and moves
// around the merge regain it. Chosen from 0, 0.3, 0.8 and 2 as the value that removes most nodes
// with no lower mean quality than 0 in the meshes of docs/results/improvement.md.
constexpr double cost_of_merge = 0.8;
// Least part of the energy that a move must gain here. Of six meshes in
// docs/results/improvement.md, with 1e-3, as in fitting, none has fewer nodes, five have up to 9
// more, and the mean quality of five is lower by 0.001 to 0.006.
constexpr double least_gain = 1e-4;

}  // namespace

// A node that may be merged into another, and the gain: the energies of its faces plus the allowed
// cost, minus the energies of the remaining faces and twice the mean energy.
struct unit_mesh_remesher::worthwhile_merge {
  double gain = 0;
  vertex_index v = none, into = none;
};

// Returns the best merge of a free node, if one is allowed and gains energy.
std::optional<unit_mesh_remesher::worthwhile_merge> unit_mesh_remesher::best_merge(vertex_index v,
                                                                                   double mean) {
  if (m_.at(v).kind != node_kind::free) return std::nullopt;
  face_list at, neighbours;
  m_.around(v, at);
  m_.neighbours(v, neighbours);
  double before = cost_of_merge - 2 * mean;
  for (const vertex_index t : at) before += energy(t);
  worthwhile_merge best;
  for (const vertex_index w : neighbours) {
    double gain = before;
    bool is_allowed_there = true;
    for (auto t = at.begin(); t != at.end() && is_allowed_there && gain > best.gain; ++t) {
      const face& f = m_.faces()[*t];
      const std::size_t i = f.corner_of(v);
      const vertex_index a = f.v[after(i)], b = f.v[adapting::before(i)];
      if (a == w || b == w) continue;
      gain -= shape_energy(m_.at(w), m_.at(a), m_.at(b), unit_);
      is_allowed_there = gain > best.gain && is_allowed(m_.at(w), m_.at(a), m_.at(b));
    }
    if (is_allowed_there && gain > best.gain && m_.can_merge(v, w, at)) best = {gain, v, w};
  }
  return best.v == none ? std::nullopt : std::optional(best);
}

double unit_mesh_remesher::mean_energy() {
  double sum = 0;
  std::size_t faces = 0;
  for (vertex_index t = 0; t < m_.faces().size(); ++t) {
    if (!m_.faces()[t].exists()) continue;
    sum += energy(t);
    ++faces;
  }
  return sum / static_cast<double>(faces);
}

// Merges nodes whose merge gains energy, those with the greatest gain first. Returns the number of
// merges.
std::size_t unit_mesh_remesher::merge_where_better() {
  const double mean = mean_energy();
  std::vector<worthwhile_merge> found;
  for (vertex_index v = 0; v < m_.nodes().size(); ++v)
    if (const auto merge = best_merge(v, mean)) found.push_back(*merge);
  std::sort(found.begin(), found.end(), [](const auto& p, const auto& q) {
    return p.gain != q.gain ? p.gain > q.gain : p.v < q.v;
  });
  std::size_t done = 0;
  for (const worthwhile_merge& planned : found) {
    const auto merge = best_merge(planned.v, mean);
    if (!merge) continue;
    m_.merge(merge->v, merge->into);
    settle_around(merge->into);
    ++done;
  }
  return done;
}

void unit_mesh_remesher::improve(metric_at field, face_test allowed) {
  constexpr int rounds = 4, sweeps = 10;
  field_ = std::move(field);
  allowed_ = std::move(allowed);
  unit_ = 0;
  least_gain_ = least_gain;
  forget_shapes();
  for (vertex_index t = 0; t < m_.faces().size(); ++t)
    if (m_.faces()[t].exists()) note_change(t);
  for (int round = 0; round < rounds && !is_stopped(); ++round) {
    flip_all();
    const std::size_t merged = merge_where_better();
    move_all(sweeps);
    if (merged == 0) return;
  }
}

}  // namespace asterism::internal::adapting
