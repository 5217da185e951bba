// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/mutable_triangulation.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal::fitting {

std::optional<side> mutable_triangulation::opposite(vertex_index t, std::size_t edge) const {
  const vertex_index s = triangles_[t].next[edge];
  if (s == none) return std::nullopt;
  const vertex_index from = triangles_[t].v[(edge + 1) % 3];
  // Uses that `from` is the second end of the edge as the next triangle runs through it.
  return side{s, (triangles_[s].corner_of(from) + 1) % 3};
}

vertex_index mutable_triangulation::far_vertex(vertex_index t, std::size_t edge) const {
  const side across = *opposite(t, edge);
  return triangles_[across.triangle].v[across.edge];
}

vertex_index mutable_triangulation::add_vertex(const fit_site& s, vertex_kind kind,
                                               const place_on_segment& place) {
  sites_.push_back(s);
  kinds_.push_back(kind);
  places_.push_back(place);
  around_.emplace_back();
  return static_cast<vertex_index>(sites_.size() - 1);
}

void mutable_triangulation::put_on_segment(vertex_index v, const place_on_segment& place) {
  kinds_[v] = vertex_kind::sliding;
  places_[v] = place;
}

fit_site mutable_triangulation::replace_site(vertex_index v, const fit_site& s) {
  return std::exchange(sites_[v], s);
}

void mutable_triangulation::keep_move(vertex_index v, const fit_site& before, double along) {
  if (logs_) log_.push_back({none, v, {}, before, places_[v].along});
  places_[v].along = along;
}

vertex_index mutable_triangulation::add_triangle() {
  triangles_.emplace_back();
  return static_cast<vertex_index>(triangles_.size() - 1);
}

void mutable_triangulation::link(vertex_index t) {
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

void mutable_triangulation::unlink(vertex_index t) {
  for (const vertex_index s : triangles_[t].next) {
    if (s == none) continue;
    for (vertex_index& back : triangles_[s].next)
      if (back == t) back = none;
  }
}

void mutable_triangulation::set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                                         const std::array<vertex_index, 3>& segment) {
  fit_triangle& here = triangles_[t];
  if (logs_) log_.push_back({t, none, here, {}, 0});
  if (here.exists()) {
    unlink(t);
    for (const vertex_index u : here.v) std::erase(around_[u], t);
  }
  here = {v, segment, {none, none, none}};
  if (!here.exists()) return;
  link(t);
  for (const vertex_index u : v) around_[u].push_back(t);
}

bool mutable_triangulation::set_subsegment(vertex_index a, vertex_index b, vertex_index segment) {
  for (const vertex_index t : around_[a]) {
    fit_triangle& here = triangles_[t];
    const std::size_t i = here.corner_of(a);
    if (here.v[(i + 1) % 3] != b) continue;
    here.segment[(i + 2) % 3] = segment;
    return true;
  }
  return false;
}

// True if v is of a kind that may go to w: a given vertex stays, and a sliding one goes along its
// segment only.
bool mutable_triangulation::may_collapse(vertex_index v, vertex_index w) const {
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

// Returns the vertices of the triangles at v, ascending, without a and b.
std::vector<vertex_index> mutable_triangulation::neighbours_but(vertex_index v, vertex_index a,
                                                                vertex_index b) const {
  std::vector<vertex_index> found;
  for (const vertex_index t : around_[v])
    for (const vertex_index x : triangles_[t].v)
      if (x != a && x != b) found.push_back(x);
  sort_unique(found);
  return found;
}

std::optional<mutable_triangulation::collapse_plan> mutable_triangulation::plan_collapse(
    vertex_index v, vertex_index w) const {
  if (!may_collapse(v, w)) return std::nullopt;
  collapse_plan plan;
  for (const vertex_index t : around_[v]) {
    const auto& has = triangles_[t].v;
    (std::find(has.begin(), has.end(), w) != has.end() ? plan.gone : plan.stay).push_back(t);
  }
  if (plan.gone.empty() || plan.stay.empty()) return std::nullopt;
  const std::vector<vertex_index> near_v = neighbours_but(v, v, w),
                                  near_w = neighbours_but(w, v, w);
  std::vector<vertex_index> common;
  std::set_intersection(near_v.begin(), near_v.end(), near_w.begin(), near_w.end(),
                        std::back_inserter(common));
  if (common.size() != plan.gone.size()) return std::nullopt;
  return plan;
}

void mutable_triangulation::begin() {
  logs_ = true;
  log_.clear();
  sites_before_ = sites_.size();
  triangles_before_ = triangles_.size();
}

std::vector<vertex_index> mutable_triangulation::undo() {
  logs_ = false;
  std::vector<vertex_index> touched;
  std::reverse(log_.begin(), log_.end());
  for (const log_entry& entry : log_) {
    if (entry.triangle != none) {
      set_triangle(entry.triangle, entry.old_triangle.v, entry.old_triangle.segment);
      touched.push_back(entry.triangle);
      continue;
    }
    sites_[entry.vertex] = entry.old_site;
    places_[entry.vertex].along = entry.old_along;
    touched.insert(touched.end(), around_[entry.vertex].begin(), around_[entry.vertex].end());
  }
  sites_.resize(sites_before_);
  kinds_.resize(sites_before_);
  places_.resize(sites_before_);
  around_.resize(sites_before_);
  triangles_.resize(triangles_before_);
  std::erase_if(touched, [this](vertex_index t) {
    return t >= triangles_.size() || !triangles_[t].exists();
  });
  sort_unique(touched);
  return touched;
}

}  // namespace asterism::internal::fitting
