// SPDX-License-Identifier: MIT
//
// Changes and energies; optimize/mutable_mesh_build.cpp has what makes one.
#include "asterism/mesh/optimize/mutable_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::fitting {

std::optional<fit_site> fitted_mesh::site_at(const point& q, double log_area) {
  const auto metric = field_->at(q);
  if (metric) return make_fit_site(q, metric.value(), log_area);
  if (!field_failure_) field_failure_ = metric.failure();
  return std::nullopt;
}

double fitted_mesh::shape_of(const std::array<vertex_index, 3>& v) const {
  const bool sharp = touches_sharp_corner(v);
  return shape_energy(sites_[v[0]], sites_[v[1]], sites_[v[2]], wanted_, sharp);
}

void fitted_mesh::judge(vertex_index t) {
  const auto& [a, b, c] = triangles_[t].v;
  changed_[t] = 1;
  shapes_[t] = shape_energy(sites_[a], sites_[b], sites_[c], wanted_, sharp_[t] != 0);
  if (judges_stars_) centres_[t] = find_centre(sites_[a], sites_[b], sites_[c]);
}

void fitted_mesh::judge_stars(bool yes) {
  judges_stars_ = yes;
  for (vertex_index t = 0; t < triangles_.size(); ++t)
    if (triangles_[t].exists()) judge(t);
}

vertex_index fitted_mesh::far_vertex(vertex_index t, std::size_t edge) const {
  const fit_triangle& next = triangles_[triangles_[t].next[edge]];
  const vertex_index from = triangles_[t].v[(edge + 1) % 3];
  // `from` is the second end of the edge as the next triangle runs through it.
  return next.v[(next.corner_of(from) + 1) % 3];
}

// A subsegment at a sharp corner cannot have the centre on its inner side, and need not.
double fitted_mesh::edge_energy(vertex_index t, std::size_t edge) const {
  const fit_triangle& here = triangles_[t];
  if (here.segment[edge] != none && sharp_[t] != 0) return 0;
  if (here.segment[edge] != none)
    return subsegment_energy(centres_[t], sites_[here.v[(edge + 1) % 3]].position,
                             sites_[here.v[(edge + 2) % 3]].position,
                             sites_[here.v[edge]].position);
  return far_site_energy(centres_[t], sites_[far_vertex(t, edge)]);
}

double fitted_mesh::own_star_energy(vertex_index t) const {
  if (!judges_stars_) return 0;
  return edge_energy(t, 0) + edge_energy(t, 1) + edge_energy(t, 2);
}

double fitted_mesh::energy(vertex_index t) const { return shapes_[t] + own_star_energy(t); }

double fitted_mesh::energy_around(vertex_index v) const {
  double sum = 0;
  for (const vertex_index t : around_[v]) sum += shapes_[t];
  if (!judges_stars_) return sum;
  for (const vertex_index t : around_[v]) {
    sum += own_star_energy(t);
    const std::size_t i = triangles_[t].corner_of(v);
    if (triangles_[t].segment[i] != none) continue;
    sum += far_site_energy(centres_[triangles_[t].next[i]], sites_[v]);
  }
  return sum;
}

double fitted_mesh::star_energy_of_pair(vertex_index t, vertex_index s) const {
  if (!judges_stars_) return 0;
  double sum = own_star_energy(t) + own_star_energy(s);
  for (const auto& [here, other] : {std::pair{t, s}, std::pair{s, t}})
    for (std::size_t i = 0; i < 3; ++i) {
      const fit_triangle& from = triangles_[here];
      if (from.segment[i] != none || from.next[i] == other) continue;
      sum += far_site_energy(centres_[from.next[i]], sites_[from.v[i]]);
    }
  return sum;
}

std::optional<fitted_mesh::target_place> fitted_mesh::displaced(vertex_index v, double length,
                                                                const point& in_disc) const {
  const fit_site& s = sites_[v];
  // Edges of triangles of the area wanted, were they equilateral.
  const double edge = 2 * elementary::exp(s.log_area / 2) / std::sqrt(std::numbers::sqrt3);
  const double u = length * edge * in_disc.x, w = length * edge * in_disc.y;
  if (kinds_[v] == vertex_kind::given) return std::nullopt;
  if (kinds_[v] == vertex_kind::free) {
    const double y = w / s.f22, x = (u - s.f12 * y) / s.f11;
    return target_place{{s.position.x + x, s.position.y + y}, 0};
  }
  const segment& on = domain_->segments[places_[v].segment];
  const point &a = domain_->vertices[on.a], &b = domain_->vertices[on.b];
  const point seen = s.seen(b.x - a.x, b.y - a.y);
  const double along = places_[v].along + u / elementary::hypot(seen.x, seen.y);
  if (!(along > 0 && along < 1)) return std::nullopt;
  return target_place{{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)}, along};
}

std::optional<double> fitted_mesh::move(vertex_index v, const target_place& to, double below) {
  if (to.position == sites_[v].position) return std::nullopt;
  for (const vertex_index t : around_[v]) {
    const fit_triangle& here = triangles_[t];
    const std::size_t i = here.corner_of(v);
    if (!surely_turns_left(to.position, sites_[here.v[(i + 1) % 3]].position,
                           sites_[here.v[(i + 2) % 3]].position))
      return std::nullopt;
  }
  const auto moved = site_at(to.position, sites_[v].log_area);
  if (!moved) return std::nullopt;
  const fit_site before = std::exchange(sites_[v], *moved);
  old_shapes_.clear();
  double sum = 0;
  for (const vertex_index t : around_[v]) {
    old_shapes_.push_back(shapes_[t]);
    const auto& [a, b, c] = triangles_[t].v;
    shapes_[t] = shape_energy(sites_[a], sites_[b], sites_[c], wanted_, sharp_[t] != 0);
    sum += shapes_[t];
    if (!(sum < below)) break;
  }
  if (sum < below && judges_stars_) {
    old_centres_.clear();
    for (const vertex_index t : around_[v]) {
      const auto& [a, b, c] = triangles_[t].v;
      old_centres_.push_back(
          std::exchange(centres_[t], find_centre(sites_[a], sites_[b], sites_[c])));
    }
    sum = energy_around(v);
    if (!(sum < below))
      for (std::size_t i = 0; i < old_centres_.size(); ++i)
        centres_[around_[v][i]] = old_centres_[i];
  }
  if (sum < below) {
    if (logs_) log_.push_back({none, v, {}, before, places_[v].along});
    places_[v].along = to.along;
    for (const vertex_index t : around_[v]) changed_[t] = 1;
    return sum;
  }
  sites_[v] = before;
  for (std::size_t i = 0; i < old_shapes_.size(); ++i) shapes_[around_[v][i]] = old_shapes_[i];
  return std::nullopt;
}

std::optional<double> fitted_mesh::flip(vertex_index t, std::size_t edge, double margin) {
  const vertex_index s = triangles_[t].next[edge];
  if (s == none || triangles_[t].segment[edge] != none) return std::nullopt;
  const fit_triangle old_t = triangles_[t], old_s = triangles_[s];
  const vertex_index c = old_t.v[edge], a = old_t.v[(edge + 1) % 3], b = old_t.v[(edge + 2) % 3];
  const std::size_t across = (old_s.corner_of(a) + 1) % 3;
  const vertex_index d = old_s.v[across];
  const double shapes = shapes_[t] + shapes_[s];
  const double first = shape_of({c, a, d});
  const double before = shapes + star_energy_of_pair(t, s) - margin;
  if (!(first < before)) return std::nullopt;
  const double second = shape_of({c, d, b});
  if (!(first + second < before)) return std::nullopt;
  // From c: its edges to a and b; from d: those to b and a.
  set_triangle(t, {c, a, d},
               {old_s.segment[(across + 1) % 3], none, old_t.segment[(edge + 2) % 3]});
  set_triangle(s, {c, d, b},
               {old_s.segment[(across + 2) % 3], old_t.segment[(edge + 1) % 3], none});
  const double after = shapes_[t] + shapes_[s] + star_energy_of_pair(t, s);
  if (after < before) return after - before - margin;
  set_triangle(s, old_s.v, old_s.segment);
  set_triangle(t, old_t.v, old_t.segment);
  return std::nullopt;
}

void fitted_mesh::link(vertex_index t) {
  fit_triangle& here = triangles_[t];
  for (std::size_t i = 0; i < 3; ++i) {
    const vertex_index a = here.v[(i + 1) % 3], b = here.v[(i + 2) % 3];
    here.next[i] = none;
    for (const vertex_index s : around_[a]) {
      fit_triangle& other = triangles_[s];
      const std::size_t j = other.corner_of(a);
      if (other.v[(j + 2) % 3] != b) continue;  // runs from b to a
      here.next[i] = s;
      other.next[(j + 1) % 3] = t;
      break;
    }
  }
}

void fitted_mesh::unlink(vertex_index t) {
  for (const vertex_index s : triangles_[t].next) {
    if (s == none) continue;
    for (vertex_index& back : triangles_[s].next)
      if (back == t) back = none;
  }
}

// No vertices: it is gone. Where several change in turn, each finds its neighbours by the direction
// in which they run through the common edge, so that old and new ones are not mistaken.
void fitted_mesh::set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                               const std::array<vertex_index, 3>& segment) {
  fit_triangle& here = triangles_[t];
  if (logs_) log_.push_back({t, none, here, {}, 0});
  if (here.exists()) {
    unlink(t);
    for (const vertex_index u : here.v) std::erase(around_[u], t);
    --count_;
  }
  here = {v, segment, {none, none, none}};
  shapes_[t] = 0;
  if (!here.exists()) return;
  link(t);
  for (const vertex_index u : v) around_[u].push_back(t);
  ++count_;
  sharp_[t] = touches_sharp_corner(v) ? 1 : 0;
  judge(t);
}

vertex_index fitted_mesh::add_triangle() {
  triangles_.emplace_back();
  shapes_.push_back(0);
  centres_.emplace_back();
  sharp_.push_back(0);
  changed_.push_back(0);
  return static_cast<vertex_index>(triangles_.size() - 1);
}

// A sliding vertex goes along its segment only.
bool fitted_mesh::is_merge_allowed(vertex_index v, vertex_index w) const {
  if (kinds_[v] == vertex_kind::given || v == w) return false;
  if (kinds_[v] == vertex_kind::free) return true;
  return std::any_of(around_[v].begin(), around_[v].end(), [&](vertex_index t) {
    const fit_triangle& here = triangles_[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = here.v[(i + 1) % 3], b = here.v[(i + 2) % 3];
      if (here.segment[i] == places_[v].segment && ((a == v && b == w) || (a == w && b == v)))
        return true;
    }
    return false;
  });
}

// The triangles at v that have w too, and the others; nothing where the result would be no
// triangulation: v and w may have no common neighbours but those in triangles with both.
std::optional<fitted_mesh::merge_plan> fitted_mesh::plan_merge(vertex_index v,
                                                               vertex_index w) const {
  if (!is_merge_allowed(v, w)) return std::nullopt;
  merge_plan plan;
  std::vector<vertex_index> near_v, near_w, common;
  const auto collect = [&](vertex_index u, std::vector<vertex_index>& into) {
    for (const vertex_index t : around_[u])
      for (const vertex_index x : triangles_[t].v)
        if (x != v && x != w) into.push_back(x);
    std::sort(into.begin(), into.end());
    into.erase(std::unique(into.begin(), into.end()), into.end());
  };
  for (const vertex_index t : around_[v]) {
    const auto& has = triangles_[t].v;
    (std::find(has.begin(), has.end(), w) != has.end() ? plan.gone : plan.stay).push_back(t);
  }
  if (plan.gone.empty() || plan.stay.empty()) return std::nullopt;
  collect(v, near_v);
  collect(w, near_w);
  std::set_intersection(near_v.begin(), near_v.end(), near_w.begin(), near_w.end(),
                        std::back_inserter(common));
  if (common.size() != plan.gone.size()) return std::nullopt;
  return plan;
}

std::optional<double> fitted_mesh::merge_cost(vertex_index v, vertex_index w) const {
  const auto plan = plan_merge(v, w);
  if (!plan) return std::nullopt;
  double cost = 0;
  for (const vertex_index t : plan->gone) cost -= shapes_[t];
  for (const vertex_index t : plan->stay) {
    std::array<vertex_index, 3> new_one = triangles_[t].v;
    new_one[triangles_[t].corner_of(v)] = w;
    cost += shape_of(new_one) - shapes_[t];
    if (!std::isfinite(cost)) return std::nullopt;
  }
  return cost;
}

void fitted_mesh::collapse(vertex_index v, vertex_index w) {
  const merge_plan plan = *plan_merge(v, w);
  // The edge from v to a common neighbour becomes the one from w, which may be a subsegment.
  std::vector<std::pair<vertex_index, vertex_index>> segment_at;
  for (const vertex_index t : plan.gone) {
    const fit_triangle& here = triangles_[t];
    for (const vertex_index u : here.v)
      if (u != v && u != w && here.segment[here.corner_of(v)] != none)
        segment_at.push_back({u, here.segment[here.corner_of(v)]});
  }
  for (const vertex_index t : plan.gone) set_triangle(t, {none, none, none}, {none, none, none});
  for (const vertex_index t : plan.stay) {
    fit_triangle next = triangles_[t];
    const std::size_t i = next.corner_of(v);
    next.v[i] = w;
    for (const auto& [u, segment] : segment_at) {
      if (next.v[(i + 1) % 3] == u) next.segment[(i + 2) % 3] = segment;
      if (next.v[(i + 2) % 3] == u) next.segment[(i + 1) % 3] = segment;
    }
    set_triangle(t, next.v, next.segment);
  }
}

double fitted_mesh::along_segment(vertex_index v, vertex_index segment) const {
  if (kinds_[v] == vertex_kind::sliding) return places_[v].along;
  return domain_->segments[segment].a == v ? 0 : 1;
}

std::optional<vertex_index> fitted_mesh::split(vertex_index t, std::size_t edge) {
  const fit_triangle old_t = triangles_[t];
  const vertex_index a = old_t.v[(edge + 1) % 3], b = old_t.v[(edge + 2) % 3];
  const vertex_index s = old_t.next[edge], on = old_t.segment[edge];
  const point &p = sites_[a].position, &q = sites_[b].position;
  target_place middle{{p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2}, 0};
  if (on != none) {
    const segment& along = domain_->segments[on];
    const point &first = domain_->vertices[along.a], &last = domain_->vertices[along.b];
    const double m = along_segment(a, on) / 2 + along_segment(b, on) / 2;
    middle = {{first.x + m * (last.x - first.x), first.y + m * (last.y - first.y)}, m};
  }
  const fit_triangle old_s = s == none ? fit_triangle{} : triangles_[s];
  const std::size_t across = s == none ? 0 : (old_s.corner_of(a) + 1) % 3;
  const auto turns = [&](const fit_triangle& whole, std::size_t i) {
    const point &x = sites_[whole.v[i]].position, &y = sites_[whole.v[(i + 1) % 3]].position,
                &z = sites_[whole.v[(i + 2) % 3]].position;
    return surely_turns_left(x, y, middle.position) && surely_turns_left(x, middle.position, z);
  };
  if (!turns(old_t, edge) || (s != none && !turns(old_s, across))) return std::nullopt;
  const auto made = site_at(middle.position, sites_[a].log_area / 2 + sites_[b].log_area / 2);
  if (!made) return std::nullopt;
  const auto v = static_cast<vertex_index>(sites_.size());
  sites_.push_back(*made);
  kinds_.push_back(on == none ? vertex_kind::free : vertex_kind::sliding);
  places_.push_back({on, middle.along});
  around_.emplace_back();
  const auto cut = [&](vertex_index whole, const fit_triangle& old, std::size_t i) {
    const auto& [x, y, z] = std::array{old.v[i], old.v[(i + 1) % 3], old.v[(i + 2) % 3]};
    const vertex_index other_half = add_triangle();
    set_triangle(whole, {x, y, v}, {on, none, old.segment[(i + 2) % 3]});
    set_triangle(other_half, {x, v, z}, {on, old.segment[(i + 1) % 3], none});
  };
  cut(t, old_t, edge);
  if (s != none) cut(s, old_s, across);
  return v;
}

void fitted_mesh::begin() {
  logs_ = true;
  log_.clear();
  sites_before_ = sites_.size();
  triangles_before_ = triangles_.size();
}

void fitted_mesh::keep() { logs_ = false; }

void fitted_mesh::undo() {
  logs_ = false;
  std::reverse(log_.begin(), log_.end());
  for (const log_entry& entry : log_) {
    if (entry.triangle != none) {
      set_triangle(entry.triangle, entry.old_triangle.v, entry.old_triangle.segment);
      continue;
    }
    sites_[entry.vertex] = entry.old_site;
    places_[entry.vertex].along = entry.old_along;
    for (const vertex_index t : around_[entry.vertex]) judge(t);
  }
  sites_.resize(sites_before_);
  kinds_.resize(sites_before_);
  places_.resize(sites_before_);
  around_.resize(sites_before_);
  triangles_.resize(triangles_before_);
  shapes_.resize(triangles_before_);
  centres_.resize(triangles_before_);
  sharp_.resize(triangles_before_);
  changed_.resize(triangles_before_);
}

}  // namespace asterism::internal::fitting
