// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/vertex_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

// Degrees above the angle bound from which an angle counts as no defect.
constexpr double settled_degrees_above = 1;
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

struct vertex_smoothing::side_products {
  metric_tensor uu, uw, ww;  // the products of the two coordinates are doubled
  double twice;              // area

  // Returns the greatest cotangent of the face's angles in the metric m, times twice its area in m.
  double greatest(const metric_tensor& m) const {
    const auto measured = [&m](const metric_tensor& p) {
      return m.m11 * p.m11 + m.m12 * p.m12 + m.m22 * p.m22;
    };
    const double u = measured(uu), w = measured(ww), inner = measured(uw);
    return std::max({inner, u - inner, w - inner});
  }
};

vertex_smoothing::vertex_smoothing(editable_mesh& m, double angle_bound, double unit,
                                   wanted_at wanted)
    : m_(m),
      tests_(m, angle_bound),
      present_(m, tests_),
      edges_(m, tests_, present_),
      ring_(cotangent_of(angle_bound + settled_degrees_above)),
      angle_bound_(angle_bound),
      unit_(unit),
      field_(std::move(wanted)),
      awake_(m.nodes().size(), 1) {
  wanted_.resize(m.nodes().size());
  m.each_node([&](vertex_index v) { wanted_[v] = look_up(m.at(v).position, m.at(v).hint); });
}

wanted_tensor vertex_smoothing::look_up(const point& q, vertex_index& hint) const {
  const metric_tensor there = field_(q, hint);
  return {there, plain_root_of_determinant(there)};
}

// True if angles of less than half of the bound are around many nodes: then the metric is not
// resolved. In two fronts that cross 22 to 51 % of the nodes have such angles, in other functions
// at most 14 % (docs/design/adaptation.md).
bool vertex_smoothing::is_in_vain() const {
  constexpr std::size_t part = 6;
  const double most = cotangent_of(angle_bound_ / 2);
  m_.note_looked_at(m_.faces().size());
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!m_.faces()[t].exists()) continue;
      const side_products sides = sides_of(static_cast<vertex_index>(t));
      for (const vertex_index u : m_.faces()[t].v)
        if (sides.greatest(wanted_[u].metric) > most * wanted_[u].root * sides.twice)
          found.push_back(u);
    }
  };
  constexpr std::size_t chunk = 4096;
  std::vector<char> is_far_below(m_.nodes().size(), 0);
  for (const vertex_index u : collect_chunks<vertex_index>(m_.faces().size(), chunk, append))
    is_far_below[u] = 1;
  const auto far_below =
      static_cast<std::size_t>(std::count(is_far_below.begin(), is_far_below.end(), char{1}));
  return part * far_below > m_.count();
}

void vertex_smoothing::run(const cancellation& stop) {
  constexpr int most_sweeps = 3;
  bool any = true;
  find_defect_free();
  for (int sweep = 0; any && sweep < most_sweeps && !stop.is_requested(); ++sweep) {
    any = false;
    for (vertex_index v = 0; v < m_.nodes().size(); ++v) {
      const node_kind kind = m_.at(v).kind;
      if (!awake_[v] || (kind != node_kind::free && kind != node_kind::sliding)) continue;
      awake_[v] = 0;
      if (is_defect_free_[v] == 0 && settle(v)) any = true;
    }
    m_.charge_work(stop);
  }
}

// Marks the nodes without a defect. These are most nodes, and take most of the time: several
// threads work, as no node moves meanwhile.
void vertex_smoothing::find_defect_free() {
  constexpr std::size_t nodes_at_once = 1024;
  const std::size_t count = m_.nodes().size();
  is_defect_free_.assign(count, 0);
  present_.forget_all();
  present_.find_all();
  parallel_chunks(count, nodes_at_once, [&](std::size_t, std::size_t begin, std::size_t end) {
    edges_around at(m_, tests_, present_);
    ring_defect ring = ring_;
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<vertex_index>(i);
      const node_kind kind = m_.at(v).kind;
      if (kind != node_kind::free && kind != node_kind::sliding) continue;
      at.turn_to(v);
      const bool has_defect = collect(at, v, ring) && present_defect(ring, v) > 0;
      is_defect_free_[v] = has_defect ? 0 : 1;
    }
  });
}

// Unmarks the nodes whose defect depends on v: its neighbours, and those across from
// it.
void vertex_smoothing::unmark_around(vertex_index v) {
  is_defect_free_[v] = 0;
  for (const vertex_index t : edges_.faces()) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    const vertex_index a = f.v[after(i)];
    is_defect_free_[a] = is_defect_free_[f.v[before(i)]] = 0;
    if (f.next[i] == none) continue;
    const face& g = m_.faces()[f.next[i]];
    is_defect_free_[g.v[after(g.corner_of(a))]] = 0;
  }
}

vertex_smoothing::side_products vertex_smoothing::sides_of(vertex_index t) const {
  const face& f = m_.faces()[t];
  const point &a = m_.at(f.v[0]).position, &b = m_.at(f.v[1]).position, &c = m_.at(f.v[2]).position;
  const double ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y;
  const double across = ux * wy, back = uy * wx;
  return {{ux * ux, 2 * ux * uy, uy * uy},
          {ux * wx, across + back, uy * wy},
          {wx * wx, 2 * wx * wy, wy * wy},
          across - back};
}

// Collects what the defect of v depends on, besides its place and its tensor. Returns false where
// there are too many faces: such a node stays.
bool vertex_smoothing::collect(edges_around& at, vertex_index v, ring_defect& ring) const {
  ring.clear();
  if (at.faces().size() > ring_defect::most_faces) return false;
  const auto add = [&](vertex_index u) { ring.add_neighbour(m_.at(u).position, wanted_[u]); };
  for (const vertex_index t : at.faces()) {
    const face& f = m_.faces()[t];
    add(f.v[after(f.corner_of(v))]);
  }
  const face& last = m_.faces()[at.faces().back()];
  add(last.v[before(last.corner_of(v))]);
  at.visit_centres_across([&ring](const face_centre& c) {
    ring.add_centre(c);
    return true;
  });
  return true;
}

double vertex_smoothing::present_defect(ring_defect& ring, vertex_index v) const {
  const double of_others = ring.of_others(m_.at(v).position, infinity);
  return of_others + ring.of_own(wanted_[v], infinity);
}

// Returns the energy of the faces around the node at hand if it were like this: the one to which
// the mesh was fitted.
double vertex_smoothing::energy_of(const node& there) {
  shapes_.measure(there, unit_, energies_);
  return energies_.sum;
}

// Lists the places at this distance from v, in units, with a smaller defect than `now`, the best
// first. The increase of the mesh's energy at a place counts as part of its defect: without that,
// errors of interpolation grow by 5 %.
void vertex_smoothing::find_better_places(vertex_index v, double step, double now,
                                          double energy_now) {
  constexpr double weight_of_energy = 4;
  better_.clear();
  const node here = m_.at(v);
  node there = here;
  const unit_displacements unit = unit_circle(here.metric);
  m_.note_looked_at(2 * work_weights::faces_for_place * directions.size() * edges_.faces().size());
  for (const point& d : directions) {
    const double x = unit_ * step * d.x, y = unit_ * step * d.y;
    point& to = there.position;
    to = {here.position.x + x * unit.first.x + y * unit.second.x,
          here.position.y + x * unit.first.y + y * unit.second.y};
    if (here.kind == node_kind::sliding) to = m_.on_segment(v, to);
    double then = ring_.of_others(to, now);
    if (!(then < now)) continue;
    vertex_index hint = here.hint;
    const wanted_tensor wanted = look_up(to, hint);
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
bool vertex_smoothing::stretches_edge(vertex_index v, const point& here, const place& there) const {
  constexpr double most = 1.4;  // units; beyond 1.5 edges were split before
  const auto length = [&](const point& from, const metric_tensor& wanted, vertex_index u) {
    const point& to = m_.at(u).position;
    const double x = to.x - from.x, y = to.y - from.y;
    return (std::sqrt(squared(wanted, x, y)) + std::sqrt(squared(wanted_[u].metric, x, y))) / 2;
  };
  const auto is_stretched = [&](vertex_index u) {
    const double then = length(there.at, there.wanted.metric, u);
    return then > most * unit_ && then > length(here, wanted_[v].metric, u);
  };
  for (const vertex_index t : edges_.faces()) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    if (is_stretched(f.v[after(i)]) || is_stretched(f.v[before(i)])) return true;
  }
  return false;
}

// Moves v to the place, and returns whether its edges and angles pass their tests.
bool vertex_smoothing::may_be_at(vertex_index v, const place& there) {
  m_.move(v, there.at);
  const face_list& at = edges_.faces();
  const auto is_low = [this](vertex_index t) { return tests_.is_low(t) && !tests_.is_exempt(t); };
  const auto has_room = [](double now, const auto& before) {
    return now >= clearance_kept || now >= before();
  };
  return edges_.all_across(has_room) && std::none_of(at.begin(), at.end(), is_low) &&
         edges_.all_of(has_room);
}

// Moves v to the best of the places found where all edges and angles pass their tests, if there is
// one.
bool vertex_smoothing::take_place(vertex_index v) {
  if (better_.empty()) return false;
  edges_.remember();
  const point here = m_.at(v).position;
  for (const place& there : better_) {
    if (stretches_edge(v, here, there) || !may_be_at(v, there)) continue;
    wanted_[v] = there.wanted;
    m_.at(v).hint = there.hint;
    edges_.accept();
    return true;
  }
  m_.move(v, here);
  return false;
}

// Moves v to a better place, if one is found; tries nearer places only where no farther one is
// taken.
bool vertex_smoothing::settle(vertex_index v) {
  edges_.turn_to(v);
  if (!collect(edges_, v, ring_)) return false;
  const double now = present_defect(ring_, v);
  if (!(now > 0) || !shapes_.gather(m_, v, edges_.faces())) return false;
  const double energy_now = energy_of(m_.at(v));
  for (const double step : {0.15, 0.05}) {
    find_better_places(v, step, now, energy_now);
    if (!take_place(v)) continue;
    unmark_around(v);
    for (const vertex_index t : edges_.faces())
      for (const vertex_index u : m_.faces()[t].v) awake_[u] = 1;
    return true;
  }
  return false;
}

}  // namespace asterism::internal::adapting
