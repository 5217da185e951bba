// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/smooth_and_swap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/core/random.hpp"

namespace asterism::internal::fitting {
namespace {

constexpr int visits_before_rest = 3;
// Least gain of a visit that counts as one, and the gain that wakes the neighbours.
constexpr double least_gain = 1e-6, waking_gain = 1e-4;
constexpr double move_margin = 1e-13, flip_margin = 1e-12;
constexpr int rounds_of_relaxing = 4;
constexpr double first_step_of_relaxing = 0.4;
constexpr std::array<double, 6> parts_of_sweep{0.25, 1, 0.25, 1, 0.25, 1};
constexpr std::array<double, 6> parts_of_relaxing{1, 0.3, 0.1, 1, 0.3, 0.1};
constexpr std::size_t visits_between_questions = 256;

}  // namespace

bool mover::is_cancelled() {
  stopped_ = stopped_ || mesh_->field_failure() || cancelled_->is_requested();
  return stopped_;
}

double mover::visit(vertex_index v, double step, std::span<const double> parts) {
  if (mesh_->around(v).empty() || mesh_->kind(v) == vertex_kind::given) return 0;
  if (tries_.size() < mesh_->sites().size()) tries_.resize(mesh_->sites().size(), 0);
  const double before = mesh_->energy_around(v);
  double energy = before;
  for (const double part : parts) {
    const std::uint32_t number = tries_[v]++;
    const double turn = 2 * std::numbers::pi * fraction_of(v, 2 * std::uint64_t{number});
    const double far = std::sqrt(fraction_of(v, 2 * std::uint64_t{number} + 1));
    const auto to = mesh_->displaced(v, part * step,
                                     {far * elementary::cos(turn), far * elementary::sin(turn)});
    if (!to) continue;
    if (const auto now = mesh_->move(v, *to, energy - move_margin)) {
      energy = *now;
      ++moves_;
    }
  }
  return energy - before;
}

double mover::flip_changed_edges(vertex_index t) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto change = mesh_->flip(t, i, flip_margin)) {
      ++flips_;
      return *change;
    }
  return 0;
}

void mover::wake(std::span<const vertex_index> vertices) {
  if (rests_.size() < mesh_->sites().size()) rests_.resize(mesh_->sites().size(), 0);
  for (const vertex_index v : vertices) rests_[v] = 0;
}

void mover::flip_all() {
  for (vertex_index t = 0; t < mesh_->triangles().size(); ++t) {
    if (!mesh_->triangles()[t].exists() || !mesh_->is_changed(t)) continue;
    mesh_->clear_changed(t);
    if (flip_changed_edges(t) < 0) wake(mesh_->triangles()[t].v);
  }
}

bool mover::sweep(double step) {
  wake({});
  for (vertex_index v = 0; v < mesh_->sites().size(); ++v) {
    if (rests_[v] >= visits_before_rest) continue;
    if (++visits_ % visits_between_questions == 0 && is_cancelled()) return false;
    const double change = visit(v, step, parts_of_sweep);
    ++rests_[v];
    if (change < -least_gain) rests_[v] = 0;
    if (change < -waking_gain)
      for (const vertex_index t : mesh_->around(v)) wake(mesh_->triangles()[t].v);
  }
  flip_all();
  return !is_cancelled();
}

std::vector<vertex_index> mover::ring(std::span<const vertex_index> seeds, int depth) {
  mark_.resize(mesh_->sites().size(), 0);
  ++last_mark_;
  std::vector<vertex_index> found;
  const auto add = [&](vertex_index v) {
    if (mark_[v] == last_mark_) return;
    mark_[v] = last_mark_;
    found.push_back(v);
  };
  for (const vertex_index v : seeds) add(v);
  for (std::size_t step = 0, begin = 0; step < static_cast<std::size_t>(depth); ++step)
    for (const std::size_t end = found.size(); begin < end; ++begin)
      for (const vertex_index t : mesh_->around(found[begin]))
        for (const vertex_index u : mesh_->triangles()[t].v) add(u);
  return found;
}

double mover::relax(std::span<const vertex_index> seeds, int depth) {
  const std::vector<vertex_index> near = ring(seeds, depth);
  double change = 0;
  for (int round = 0; round < rounds_of_relaxing; ++round) {
    const double step = first_step_of_relaxing / (1 + 0.3 * round);
    for (const vertex_index v : near) {
      change += visit(v, step, parts_of_relaxing);
      const std::vector<vertex_index> around = mesh_->around(v);  // flips change it
      for (const vertex_index t : around) change += flip_changed_edges(t);
    }
  }
  return change;
}

}  // namespace asterism::internal::fitting
