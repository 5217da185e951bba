// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/mutable_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/optimize/mutable_mesh_build.hpp"

namespace asterism::internal::fitting {
namespace {

constexpr std::array<vertex_index, 3> no_vertices{none, none, none};

// Returns the point of the segment from a to b this part of the way.
point part_of_way(const point& a, const point& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

}  // namespace

result<mutable_mesh> mutable_mesh::build(const domain& d, const metric_field& field,
                                         const mesh& start, double angle_bound,
                                         double target_angle) {
  field_sampler sampler(field);
  auto net = build_triangulation(d, sampler, start);
  if (!net) return net.failure();
  choose_areas(net.value());
  return mutable_mesh(std::move(net).value(), std::move(sampler), angle_bound, target_angle);
}

mutable_mesh::mutable_mesh(mutable_triangulation net, field_sampler sampler, double angle_bound,
                           double target_angle)
    : net_(std::move(net)),
      sampler_(std::move(sampler)),
      energies_(net_, angle_bound, target_angle) {}

std::optional<fit_site> mutable_mesh::site_at(const point& q, double log_area) {
  const auto s = sampler_.at(q);
  if (!s) return std::nullopt;
  return make_fit_site(q, s->metric, log_area);
}

void mutable_mesh::set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                                const std::array<vertex_index, 3>& segment) {
  net_.set_triangle(t, v, segment);
  energies_.judge(net_, t);
}

std::optional<mutable_mesh::target_place> mutable_mesh::displaced(vertex_index v, double length,
                                                                  const point& in_disc) const {
  if (kind(v) == vertex_kind::given) return std::nullopt;
  const fit_site& s = sites()[v];
  // Takes as unit the edge of an equilateral triangle of the area wanted.
  const double edge = 2 * elementary::exp(s.log_area / 2) / std::sqrt(std::numbers::sqrt3);
  const double u = length * edge * in_disc.x, w = length * edge * in_disc.y;
  if (kind(v) == vertex_kind::free) {
    const double y = w / s.f22, x = (u - s.f12 * y) / s.f11;
    return target_place{{s.position.x + x, s.position.y + y}, 0};
  }
  const domain& shape = net_.shape();
  const segment& on = shape.segments[place(v).segment];
  const point &a = shape.vertices[on.a], &b = shape.vertices[on.b];
  const point seen = s.seen(b.x - a.x, b.y - a.y);
  const double along = place(v).along + u / elementary::hypot(seen.x, seen.y);
  if (!(along > 0 && along < 1)) return std::nullopt;
  return target_place{part_of_way(a, b, along), along};
}

// True if all triangles at v would surely turn left with v at this place.
bool mutable_mesh::turns_left_at(vertex_index v, const point& to) const {
  return std::all_of(around(v).begin(), around(v).end(), [&](vertex_index t) {
    const fit_triangle& here = triangles()[t];
    const std::size_t i = here.corner_of(v);
    return surely_turns_left(to, sites()[here.v[(i + 1) % 3]].position,
                             sites()[here.v[(i + 2) % 3]].position);
  });
}

// Puts a vertex at another place for as long as this exists. Restores its site and the energies
// around it unless the move is kept.
class mutable_mesh::trial_move {
 public:
  trial_move(mutable_mesh& m, vertex_index v, const fit_site& moved)
      : mesh_(m), v_(v), before_(m.net_.replace_site(v, moved)) {}
  trial_move(const trial_move&) = delete;
  trial_move& operator=(const trial_move&) = delete;
  ~trial_move() {
    if (kept_) return;
    mesh_.net_.replace_site(v_, before_);
    mesh_.energies_.restore_around(mesh_.net_, v_);
  }

  double energy(double below) { return mesh_.energies_.try_around(mesh_.net_, v_, below); }
  void keep(double along) {
    mesh_.net_.keep_move(v_, before_, along);
    for (const vertex_index t : mesh_.around(v_)) mesh_.energies_.set_changed(t);
    kept_ = true;
  }

 private:
  mutable_mesh& mesh_;
  vertex_index v_;
  fit_site before_;
  bool kept_ = false;
};

std::optional<double> mutable_mesh::move(vertex_index v, const target_place& to, double below) {
  if (to.position == sites()[v].position || !turns_left_at(v, to.position)) return std::nullopt;
  const auto moved = site_at(to.position, sites()[v].log_area);
  if (!moved) return std::nullopt;
  trial_move trial(*this, v, *moved);
  const double energy = trial.energy(below);
  if (!(energy < below)) return std::nullopt;
  trial.keep(to.along);
  return energy;
}

std::optional<double> mutable_mesh::flip(vertex_index t, std::size_t edge, double margin) {
  const auto across = net_.opposite(t, edge);
  if (!across || triangles()[t].segment[edge] != none) return std::nullopt;
  const auto [s, far] = *across;
  const fit_triangle old_t = triangles()[t], old_s = triangles()[s];
  const vertex_index c = old_t.v[edge], a = old_t.v[(edge + 1) % 3], b = old_t.v[(edge + 2) % 3];
  const vertex_index d = old_s.v[far];
  const double first = energies_.shape_of(net_, {c, a, d});
  const double before =
      energies_.shape(t) + energies_.shape(s) + energies_.of_edges_of_pair(net_, t, s) - margin;
  if (!(first < before)) return std::nullopt;
  const double second = energies_.shape_of(net_, {c, d, b});
  if (!(first + second < before)) return std::nullopt;
  // Keeps the segments of the outer edges: t has those at a, s those at b.
  set_triangle(t, {c, a, d}, {old_s.segment[(far + 1) % 3], none, old_t.segment[(edge + 2) % 3]});
  set_triangle(s, {c, d, b}, {old_s.segment[(far + 2) % 3], old_t.segment[(edge + 1) % 3], none});
  const double after =
      energies_.shape(t) + energies_.shape(s) + energies_.of_edges_of_pair(net_, t, s);
  if (after < before) return after - before - margin;
  set_triangle(s, old_s.v, old_s.segment);
  set_triangle(t, old_t.v, old_t.segment);
  return std::nullopt;
}

std::optional<double> mutable_mesh::collapse_cost(vertex_index v, vertex_index w) const {
  const auto plan = net_.plan_collapse(v, w);
  if (!plan) return std::nullopt;
  double cost = 0;
  for (const vertex_index t : plan->gone) cost -= energies_.shape(t);
  for (const vertex_index t : plan->stay) {
    std::array<vertex_index, 3> new_one = triangles()[t].v;
    new_one[triangles()[t].corner_of(v)] = w;
    cost += energies_.shape_of(net_, new_one) - energies_.shape(t);
    if (!std::isfinite(cost)) return std::nullopt;
  }
  return cost;
}

void mutable_mesh::collapse(vertex_index v, vertex_index w) {
  const auto plan = *net_.plan_collapse(v, w);
  // Remembers the segment of each edge from v to a common neighbour. That edge becomes the one from
  // w, which may be a subsegment.
  std::vector<std::pair<vertex_index, vertex_index>> segment_at;
  for (const vertex_index t : plan.gone) {
    const fit_triangle& here = triangles()[t];
    for (const vertex_index u : here.v)
      if (u != v && u != w && here.segment[here.corner_of(v)] != none)
        segment_at.push_back({u, here.segment[here.corner_of(v)]});
  }
  for (const vertex_index t : plan.gone) set_triangle(t, no_vertices, no_vertices);
  for (const vertex_index t : plan.stay) {
    fit_triangle next = triangles()[t];
    const std::size_t i = next.corner_of(v);
    next.v[i] = w;
    for (const auto& [u, segment] : segment_at) {
      if (next.v[(i + 1) % 3] == u) next.segment[(i + 2) % 3] = segment;
      if (next.v[(i + 2) % 3] == u) next.segment[(i + 1) % 3] = segment;
    }
    set_triangle(t, next.v, next.segment);
  }
}

double mutable_mesh::along_segment(vertex_index v, vertex_index segment) const {
  if (kind(v) == vertex_kind::sliding) return place(v).along;
  return net_.shape().segments[segment].a == v ? 0 : 1;
}

// Returns the middle of the edge. On a subsegment, it is the point half way along the segment's
// part.
mutable_mesh::target_place mutable_mesh::middle_of(vertex_index t, std::size_t edge) const {
  const fit_triangle& here = triangles()[t];
  const vertex_index a = here.v[(edge + 1) % 3], b = here.v[(edge + 2) % 3];
  const vertex_index on = here.segment[edge];
  if (on == none) {
    const point &p = sites()[a].position, &q = sites()[b].position;
    return {{p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2}, 0};
  }
  const segment& whole = net_.shape().segments[on];
  const point &first = net_.shape().vertices[whole.a], &last = net_.shape().vertices[whole.b];
  const double along = along_segment(a, on) / 2 + along_segment(b, on) / 2;
  return {part_of_way(first, last, along), along};
}

// True if both halves of the triangle would surely turn left.
bool mutable_mesh::can_cut(const side& whole, const point& middle) const {
  const auto& v = triangles()[whole.triangle].v;
  const point &x = sites()[v[whole.edge]].position, &y = sites()[v[(whole.edge + 1) % 3]].position,
              &z = sites()[v[(whole.edge + 2) % 3]].position;
  return surely_turns_left(x, y, middle) && surely_turns_left(x, middle, z);
}

// Cuts a triangle in two, from the vertex across the edge to the edge's middle.
void mutable_mesh::cut(const fit_triangle& whole, const side& at, vertex_index middle) {
  const std::size_t i = at.edge;
  const vertex_index x = whole.v[i], y = whole.v[(i + 1) % 3], z = whole.v[(i + 2) % 3];
  const vertex_index on = whole.segment[i], other_half = net_.add_triangle();
  set_triangle(at.triangle, {x, y, middle}, {on, none, whole.segment[(i + 2) % 3]});
  set_triangle(other_half, {x, middle, z}, {on, whole.segment[(i + 1) % 3], none});
}

std::optional<vertex_index> mutable_mesh::split(vertex_index t, std::size_t edge) {
  const side here{t, edge};
  const auto across = net_.opposite(t, edge);
  const target_place middle = middle_of(t, edge);
  if (!can_cut(here, middle.position)) return std::nullopt;
  if (across && !can_cut(*across, middle.position)) return std::nullopt;
  const fit_triangle old_t = triangles()[t];
  const fit_triangle old_s = across ? triangles()[across->triangle] : fit_triangle{};
  const vertex_index a = old_t.v[(edge + 1) % 3], b = old_t.v[(edge + 2) % 3];
  const auto made = site_at(middle.position, sites()[a].log_area / 2 + sites()[b].log_area / 2);
  if (!made) return std::nullopt;
  const vertex_index on = old_t.segment[edge];
  const auto kind = on == none ? vertex_kind::free : vertex_kind::sliding;
  const vertex_index v = net_.add_vertex(*made, kind, {on, middle.along});
  cut(old_t, here, v);
  if (across) cut(old_s, *across, v);
  return v;
}

void mutable_mesh::undo() {
  const std::vector<vertex_index> touched = net_.undo();
  energies_.truncate(triangles().size());
  for (const vertex_index t : touched) energies_.judge(net_, t);
}

}  // namespace asterism::internal::fitting
