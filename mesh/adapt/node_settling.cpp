// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/node_settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr double slant = 1 / std::numbers::sqrt2;
constexpr std::array<point, 8> directions = {{{1, 0},
                                              {slant, slant},
                                              {0, 1},
                                              {-slant, slant},
                                              {-1, 0},
                                              {-slant, -slant},
                                              {0, -1},
                                              {slant, -slant}}};

}  // namespace

mesh_to_smooth::mesh_to_smooth(editable_mesh& mesh, double angle_bound, double unit_length,
                               wanted_at field)
    : m(mesh),
      tests(mesh, angle_bound),
      present(mesh, tests),
      unit(unit_length),
      wanted_field(std::move(field)),
      wanted(mesh.nodes().size()),
      is_awake(mesh.nodes().size(), 1),
      is_defect_free(mesh.nodes().size(), 0) {
  m.each_node([&](vertex_index v) { wanted[v] = look_up(m.at(v).position, m.at(v).hint); });
}

wanted_tensor mesh_to_smooth::look_up(const point& q, vertex_index& hint) const {
  const metric_tensor there = wanted_field(q, hint);
  return {there, plain_root_of_determinant(there)};
}

// Collects what the defect of v depends on, besides its place and its tensor. Returns false where
// there are too many faces: such a node stays.
bool node_settling::collect(vertex_index v) {
  edges_.turn_to(v);
  ring_.clear();
  if (edges_.faces().size() > ring_defect::most_faces) return false;
  const auto add = [&](vertex_index u) {
    ring_.add_neighbour(m_.at(u).position, whole_.wanted[u]);
  };
  for (const vertex_index t : edges_.faces()) {
    const face& f = m_.faces()[t];
    add(f.v[after(f.corner_of(v))]);
  }
  const face& last = m_.faces()[edges_.faces().back()];
  add(last.v[before(last.corner_of(v))]);
  edges_.visit_centres_across([this](const face_centre& c) {
    ring_.add_centre(c);
    return true;
  });
  return true;
}

double node_settling::present_defect(vertex_index v) {
  const double of_others = ring_.of_others(m_.at(v).position, infinity);
  return of_others + ring_.of_own(whole_.wanted[v], infinity);
}

bool node_settling::has_defect(vertex_index v) { return collect(v) && present_defect(v) > 0; }

// Returns the energy of the faces around the node at hand if it were like this: the one to which
// the mesh was fitted.
double node_settling::energy_of(const node& there) {
  shapes_.measure(there, whole_.unit, energies_);
  return energies_.sum;
}

// Lists the places at this distance from v, in units, with a smaller defect than `now`, the best
// first. The increase of the mesh's energy at a place counts as part of its defect: without that,
// errors of interpolation grow by 5 %.
void node_settling::find_better_places(vertex_index v, double step, double now, double energy_now) {
  constexpr double weight_of_energy = 4;
  better_.clear();
  const node here = m_.at(v);
  node there = here;
  const unit_displacements unit = unit_circle(here.metric);
  m_.note_looked_at(2 * work_weights::faces_for_place * directions.size() * edges_.faces().size());
  for (const point& d : directions) {
    const double x = whole_.unit * step * d.x, y = whole_.unit * step * d.y;
    point& to = there.position;
    to = {here.position.x + x * unit.first.x + y * unit.second.x,
          here.position.y + x * unit.first.y + y * unit.second.y};
    if (here.kind == node_kind::sliding) to = m_.on_segment(v, to);
    double then = ring_.of_others(to, now);
    if (!(then < now)) continue;
    vertex_index hint = here.hint;
    const wanted_tensor wanted = whole_.look_up(to, hint);
    then += ring_.of_own(wanted, now - then);
    if (!(then < now)) continue;
    // The energy is infinite where a face turns over, though its defect is finite.
    then += weight_of_energy * (energy_of(there) - energy_now);
    if (!(then < now)) continue;
    const auto is_better = [](double defect, const place& p) { return defect < p.defect; };
    better_.insert(std::upper_bound(better_.begin(), better_.end(), then, is_better),
                   {to, wanted, hint, then});
  }
}

// True if an edge at v would be longer than its limit, and longer than it is now, by the mean of
// both ends' wanted tensors.
bool node_settling::stretches_edge(vertex_index v, const point& here, const place& there) const {
  constexpr double most = 1.4;  // units; beyond 1.5 edges were split before
  const auto length = [&](const point& from, const metric_tensor& wanted, vertex_index u) {
    const point& to = m_.at(u).position;
    const double x = to.x - from.x, y = to.y - from.y;
    return (std::sqrt(squared(wanted, x, y)) + std::sqrt(squared(whole_.wanted[u].metric, x, y))) /
           2;
  };
  const auto is_stretched = [&](vertex_index u) {
    const double then = length(there.at, there.wanted.metric, u);
    return then > most * whole_.unit && then > length(here, whole_.wanted[v].metric, u);
  };
  for (const vertex_index t : edges_.faces()) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    if (is_stretched(f.v[after(i)]) || is_stretched(f.v[before(i)])) return true;
  }
  return false;
}

// Moves v to the place, and returns whether its edges and angles pass their tests.
bool node_settling::may_be_at(vertex_index v, const place& there) {
  m_.move(v, there.at);
  const face_list& at = edges_.faces();
  const auto is_low = [this](vertex_index t) {
    return whole_.tests.is_low(t) && !whole_.tests.is_exempt(t);
  };
  const auto has_room = [](double now, const auto& before) {
    return now >= clearance_kept || now >= before();
  };
  return edges_.all_across(has_room) && std::none_of(at.begin(), at.end(), is_low) &&
         edges_.all_of(has_room);
}

// Moves v to the best of the places found where all edges and angles pass their tests, if there is
// one.
bool node_settling::take_place(vertex_index v) {
  if (better_.empty()) return false;
  edges_.remember();
  const point here = m_.at(v).position;
  for (const place& there : better_) {
    if (stretches_edge(v, here, there) || !may_be_at(v, there)) continue;
    whole_.wanted[v] = there.wanted;
    m_.at(v).hint = there.hint;
    edges_.accept();
    return true;
  }
  m_.move(v, here);
  return false;
}

// Marks the nodes that a move of v concerns. Its neighbours, and the nodes across from it, may have
// a defect now; the nodes of its faces are to be tried again. Writes a flag only where it changes:
// threads of two parts may have the same node across, whose flag is then clear from the start.
void node_settling::note_move(vertex_index v) {
  const auto unmark = [this](vertex_index u) {
    if (whole_.is_defect_free[u] != 0) whole_.is_defect_free[u] = 0;
  };
  unmark(v);
  for (const vertex_index t : edges_.faces()) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    const vertex_index a = f.v[after(i)];
    unmark(a);
    unmark(f.v[before(i)]);
    for (const vertex_index u : f.v) whole_.is_awake[u] = 1;
    if (f.next[i] == none) continue;
    const face& g = m_.faces()[f.next[i]];
    unmark(g.v[after(g.corner_of(a))]);
  }
}

// Moves v to a better place, if one is found; tries nearer places only where no farther one is
// taken.
bool node_settling::settle(vertex_index v) {
  if (!collect(v)) return false;
  const double now = present_defect(v);
  if (!(now > 0) || !shapes_.gather(m_, v, edges_.faces())) return false;
  const double energy_now = energy_of(m_.at(v));
  for (const double step : {0.15, 0.05}) {
    find_better_places(v, step, now, energy_now);
    if (!take_place(v)) continue;
    note_move(v);
    return true;
  }
  return false;
}

}  // namespace asterism::internal::adapting
