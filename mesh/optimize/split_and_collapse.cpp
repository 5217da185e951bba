// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/split_and_collapse.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal::fitting {
namespace {

// Least energy of a triangle, with the edges as it sees them, that is worth an attempt.
constexpr double worth_an_operation = 0.05;
constexpr double least_gain = 1e-3;

class surgeon {
 public:
  surgeon(mutable_mesh& m, mover& moves) : mesh_(m), moves_(moves) {}

  surgery_report run() {
    std::vector<std::pair<double, vertex_index>> patients;
    for (vertex_index t = 0; t < mesh_.triangles().size(); ++t)
      if (needs_help(t)) patients.push_back({-mesh_.energy(t), t});
    std::sort(patients.begin(), patients.end());
    for (const auto& [energy, t] : patients) {
      if (moves_.is_cancelled()) break;
      if (needs_help(t)) help(t);
    }
    return report_;
  }

 private:
  bool needs_help(vertex_index t) const {
    return mesh_.triangles()[t].exists() && mesh_.energy(t) > worth_an_operation;
  }

  void help(vertex_index t) {
    const auto before = mesh_.triangles()[t].v;
    for (const vertex_index v : before)
      if (try_collapsing(v)) return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh_.triangles()[t].v != before) return;  // undone, it has other numbers
      if (try_splitting(t, i)) return;
    }
  }

  double energy_of(const std::vector<vertex_index>& triangles) const {
    double sum = 0;
    for (const vertex_index t : triangles) sum += mesh_.energy(t);
    return sum;
  }

  // Returns the triangles that have one of the vertices, each once.
  std::vector<vertex_index> triangles_at(const std::vector<vertex_index>& vertices) const {
    std::vector<vertex_index> found;
    for (const vertex_index v : vertices)
      found.insert(found.end(), mesh_.around(v).begin(), mesh_.around(v).end());
    sort_unique(found);
    return found;
  }

  // Ends an attempt: relaxes around the seeds and keeps the change if the energy has fallen by
  // enough, else undoes it. The change itself altered the energy of the triangles at `near`;
  // relaxing adds what it returns.
  bool conclude(double before, const std::vector<vertex_index>& near,
                const std::vector<vertex_index>& seeds, int depth) {
    ++report_.tried;
    const double by_hand = energy_of(triangles_at(near)) - before;
    if (by_hand + moves_.relax(seeds, depth) < -least_gain) {
      mesh_.keep();
      moves_.wake(moves_.ring(seeds, depth + 1));
      return true;
    }
    mesh_.undo();
    return false;
  }

  // Tries to collapse v into the neighbour that costs least. True if that was kept.
  bool try_collapsing(vertex_index v) {
    std::optional<std::pair<double, vertex_index>> best;
    std::vector<vertex_index> near = moves_.ring(std::vector<vertex_index>{v}, 1);
    for (const vertex_index w : near)
      if (const auto cost = mesh_.collapse_cost(v, w))
        if (!best || std::pair(*cost, w) < *best) best = {*cost, w};
    if (!best) return false;
    const double before = energy_of(triangles_at(near));
    mesh_.begin();
    mesh_.collapse(v, best->second);
    std::erase(near, v);
    if (!conclude(before, near, near, 1)) return false;
    ++report_.collapsed;
    return true;
  }

  bool try_splitting(vertex_index t, std::size_t edge) {
    std::vector<vertex_index> near = {mesh_.triangles()[t].v.begin(), mesh_.triangles()[t].v.end()};
    if (mesh_.triangles()[t].next[edge] != none) near.push_back(mesh_.far_vertex(t, edge));
    const double before = energy_of(triangles_at(near));
    mesh_.begin();
    const auto v = mesh_.split(t, edge);
    if (!v) {
      mesh_.undo();
      return false;
    }
    if (!conclude(before, near, std::vector<vertex_index>{*v}, 2)) return false;
    ++report_.split;
    return true;
  }

  mutable_mesh& mesh_;
  mover& moves_;
  surgery_report report_;
};

}  // namespace

surgery_report operate(mutable_mesh& m, mover& moves) { return surgeon(m, moves).run(); }

}  // namespace asterism::internal::fitting
