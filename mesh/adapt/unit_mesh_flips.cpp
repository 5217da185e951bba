// SPDX-License-Identifier: MIT
//
// Improves the shapes of a unit mesh's triangles: flips, moves.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

// Lower bound of a triangle's energy, with which sums are cut short. The energy is 1 for an
// equilateral triangle and more for others; the tenth below 1 is far more than rounding
// errors.
constexpr double least_energy = 0.9;

}  // namespace

// Queues the edges of t for flips and its nodes for moves, and forgets its energy.
void unit_mesh_remesher::note_change(vertex_index t) {
  ++changes_;
  for (const vertex_index v : m_.faces()[t].v) node_state_of(v) = {changes_, true};
  face_state& state = state_of(t);
  const bool was_due = state.is_due;
  state = {};
  state.change = changes_;
  state.is_due = true;
  if (t < flips_in_vain_.size()) flips_in_vain_[t] = {never, never, never};
  if (!was_due) due_.push_back(t);
  if (changed_) changed_->push_back(t);
}

// Queues all edges for flips and all nodes for moves, as one change of all faces. Requires that no
// energies are known, and that changed faces are not listed.
void unit_mesh_remesher::note_change_of_all() {
  ++changes_;
  make_states();
  m_.each_node([this](vertex_index v) { node_states_[v] = {changes_, true}; });
  constexpr std::size_t faces_at_once = 16384;  // for a thread
  const auto append = [this](std::size_t begin, std::size_t end, face_numbers& newly_due) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!m_.faces()[t].exists()) continue;
      face_state& state = face_states_[t];
      state.change = changes_;
      if (!std::exchange(state.is_due, true)) newly_due.push_back(static_cast<vertex_index>(t));
    }
  };
  const face_numbers newly_due =
      collect_chunks<vertex_index>(m_.faces().size(), faces_at_once, append);
  due_.insert(due_.end(), newly_due.begin(), newly_due.end());
}

// True if a flip of this edge of t was tested in vain, and neither t nor the face across, s, has
// changed since.
bool unit_mesh_remesher::is_flip_in_vain(vertex_index t, std::size_t edge, vertex_index s) {
  return remembers_flips() && in_vain_at(t)[edge] == state_of(s).change;
}

// Notes a test in vain of this edge of t, which is the edge `beyond` of s.
void unit_mesh_remesher::note_flip_in_vain(vertex_index t, std::size_t edge, vertex_index s,
                                           std::size_t beyond) {
  if (!remembers_flips()) return;
  in_vain_at(t)[edge] = state_of(s).change;
  in_vain_at(s)[beyond] = state_of(t).change;
}

bool unit_mesh_remesher::flip_if_better(vertex_index t, std::size_t edge) {
  const face& f = m_.faces()[t];
  const vertex_index s = f.next[edge];
  if (s == none || f.segment[edge] != none) return false;
  if (is_flip_in_vain(t, edge, s)) return false;
  const double now = shape_of(t) + shape_of(s);
  // Least energy of two triangles at which a flip is tried. Two equilateral triangles have the
  // least possible energy, 2, so a flip can gain little below this.
  constexpr double good = 2.1;
  if (now < good) return false;
  const face& g = m_.faces()[s];
  const std::size_t j = after(g.corner_of(f.v[after(edge)]));
  note_flip_in_vain(t, edge, s, j);
  const node &c = m_.at(f.v[edge]), &a = m_.at(f.v[after(edge)]), &b = m_.at(f.v[before(edge)]);
  const node& d = m_.at(g.v[j]);
  // Least part of the energy that a flip must gain. Far above rounding errors of an energy, unless
  // a triangle is nearly flat, so that flips do not undo each other; the callers' loops are bounded
  // as well.
  constexpr double margin = 1e-6;
  const double most = now * (1 - margin);
  // Returns false where the flip would turn a triangle over, whose energy is infinite, or gain too
  // little.
  const double one = shape_energy(c, a, d, 0);
  if (!(one + least_energy < most)) return false;
  const double other = shape_energy(d, b, c, 0);
  if (!(one + other < most) || !is_allowed(c, a, d) || !is_allowed(d, b, c)) return false;
  m_.flip(t, edge);
  note_change(t);
  note_change(s);
  state_of(t).shape = one;
  state_of(s).shape = other;
  return true;
}

// Notes that the faces at v have changed, and flips edges from v outwards until no flip lowers the
// energy.
void unit_mesh_remesher::settle_around(vertex_index v) {
  face_list at;
  m_.around(v, at);
  for (const vertex_index t : at) note_change(t);
  constexpr int most = 8;
  for (int round = 0; round < most; ++round) {
    bool any = false;
    for (const vertex_index t : at) {
      const face& f = m_.faces()[t];
      if (f.v[0] != v && f.v[1] != v && f.v[2] != v) continue;
      any = flip_if_better(t, f.corner_of(v)) || any;
    }
    if (!any) return;
    m_.around(v, at);
  }
}

// Flips queued edges until no flip lowers the energy.
void unit_mesh_remesher::flip_all() {
  const std::size_t most = 20 * m_.faces().size();
  for (std::size_t next = 0; next < due_.size() && next < most; ++next) {
    const vertex_index t = due_[next];
    state_of(t).is_due = false;
    for (std::size_t i = 0; i < 3 && m_.faces()[t].exists(); ++i) flip_if_better(t, i);
  }
  m_.note_looked_at(work_weights::faces_for_flip * due_.size());
  for (const vertex_index t : due_) state_of(t).is_due = false;
  due_.clear();
}

// Moves v if the sum of its faces' energies is then below `most`; computes these energies.
bool unit_mesh_remesher::try_move(vertex_index v, const point& to, const face_list& at,
                                  const node_ring& ring, double most, node_ring::energies& then) {
  const node old = m_.at(v);
  m_.move(v, to);
  measure(v);
  ring.measure(m_.at(v), unit_, then);
  const auto may_be = [this](vertex_index t) {
    const face& f = m_.faces()[t];
    return is_allowed(m_.at(f.v[0]), m_.at(f.v[1]), m_.at(f.v[2]));
  };
  if (then.sum < most && (!allowed_ || std::all_of(at.begin(), at.end(), may_be))) return true;
  m_.at(v) = old;
  return false;
}

// True if a move of the node to a place that is best for its triangles would hardly lower their
// energy: by about 5 d^2 of 6 for six nearly equilateral triangles, at d units.
bool unit_mesh_remesher::is_near(const node& n, const point& goal) const {
  constexpr double near = 0.05;  // units
  return !wants_few() && squared(n.metric, goal.x - n.position.x, goal.y - n.position.y) <
                             near * near * unit_ * unit_;
}

// Moves each queued node to the place that is best for its triangles, if that lowers their energy.
void unit_mesh_remesher::smooth() {
  face_list at;
  node_ring ring;
  node_ring::energies now, then;
  for (vertex_index v = 0; v < m_.nodes().size(); ++v) {
    if (was_inside(v) || !node_state_of(v).is_restless) continue;
    const node_kind kind = m_.at(v).kind;
    if (kind == node_kind::given || kind == node_kind::gone) continue;
    node_state_of(v).is_restless = false;
    m_.around(v, at);
    if (!ring.gather(m_, v, at)) continue;
    ring.measure(m_.at(v), unit_, now);
    const point goal = ring.best_place(unit_, now), here = m_.at(v).position;
    if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || is_near(m_.at(v), goal)) continue;
    for (const double part : {0.8, 0.3}) {
      point to{here.x + part * (goal.x - here.x), here.y + part * (goal.y - here.y)};
      if (kind == node_kind::sliding) to = m_.on_segment(v, to);
      if (!try_move(v, to, at, ring, now.sum * (1 - least_gain_), then)) continue;
      for (std::size_t k = 0; k < at.size(); ++k) {
        note_change(at[k]);
        state_of(at[k]).shape = then.shape[k];
      }
      break;
    }
  }
}

}  // namespace asterism::internal::adapting
