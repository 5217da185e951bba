// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/delaunay_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/mesh/data/site_box.hpp"

namespace asterism::internal {

delaunay_triangulation::delaunay_triangulation(std::vector<site> sites,
                                               const star_predicates& kernel)
    : sites_(std::move(sites)), frame_(static_cast<vertex_index>(sites_.size())), kernel_(&kernel) {
  // Largest number of steps for each site. In a good order a site takes about 20; this limit costs
  // ten microseconds, less than stars made one by one.
  constexpr std::size_t at_least = 100'000, for_each = 400;
  most_steps_ = at_least + for_each * sites_.size();
  is_framed_ = add_frame();
}

// Puts four corners around the box of the sites, at a distance of the box's length.
bool delaunay_triangulation::add_frame() {
  const bounding_box box = box_of_sites(sites_);
  const double margin = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const point low{box.low.x - margin, box.low.y - margin},
      high{box.high.x + margin, box.high.y + margin};
  const metric_tensor metric = sites_.front().metric;
  for (const point& q : {low, point{high.x, low.y}, high, point{low.x, high.y}})
    sites_.push_back({q, metric});
  const vertex_index n = frame_;
  face_at_.assign(sites_.size(), none);
  faces_.reserve(2 * sites_.size() + 2);
  faces_.resize(2);
  put(0, {{n, n + 1, n + 2}, {none, 1, none}, {}});
  put(1, {{n, n + 2, n + 3}, {none, none, 0}, {}});
  const bool outside =
      low.x < box.low.x && low.y < box.low.y && high.x > box.high.x && high.y > box.high.y;
  const bool finite = std::isfinite(low.x) && std::isfinite(low.y) && std::isfinite(high.x) &&
                      std::isfinite(high.y);
  if (!outside || !finite) return false;
  if (!stays({0, 1}, *kernel_)) flip({0, 1});
  return true;
}

bool delaunay_triangulation::stays(const place& p, const star_predicates& kernel) const {
  const face& f = faces_[p.face];
  if (f.across[p.corner] == none || f.fixed[p.corner]) return true;
  const vertex_index apex = f.corner[p.corner], a = f.corner[after(p.corner)],
                     b = f.corner[before(p.corner)];
  const place q = other_side(p);
  const site &at_a = sites_[a], &at_b = sites_[b], &left = sites_[apex],
             &right = sites_[faces_[q.face].corner[q.corner]];
  const uncertain_bool quick = semi_static::insertion_test_equal_metrics(at_a, at_b, left, right);
  if (!quick.certain()) return kernel.edge_test(at_a, at_b, left, right);
  ++kernel.counters().at(predicate::edge_test, tier::semi_static);
  return quick.value();
}

bool delaunay_triangulation::is_sound(std::uint32_t at, const star_predicates& kernel) const {
  const face& f = faces_[at];
  if (kernel.orientation(sites_[f.corner[0]].position, sites_[f.corner[1]].position,
                         sites_[f.corner[2]].position) != sign::positive)
    return false;
  for (std::uint32_t i = 0; i < 3; ++i)
    if (at < f.across[i] && !stays({at, i}, kernel)) return false;
  return true;
}

delaunay_triangulation::place delaunay_triangulation::next_around(const place& p) const {
  const face& f = faces_[p.face];
  const std::uint32_t next = f.across[after(p.corner)];
  if (next == none) return {};
  return {next, corner_of(faces_[next], f.corner[p.corner])};
}

// Finds the face left of an edge. Searches around both ends in turn: one end may have very many
// edges, or be in the frame, with faces on one side alone.
std::optional<delaunay_triangulation::place> delaunay_triangulation::find_edge(vertex_index a,
                                                                               vertex_index b) {
  const place first_a = at(a), first_b = at(b);
  place by_a = first_a, by_b = first_b;
  while (take_step() && (by_a.face != none || by_b.face != none)) {
    if (by_a.face != none) {
      if (faces_[by_a.face].corner[after(by_a.corner)] == b)
        return place{by_a.face, before(by_a.corner)};
      by_a = next_around(by_a);
      if (by_a.face == first_a.face) break;
    }
    if (by_b.face != none) {
      if (faces_[by_b.face].corner[before(by_b.corner)] == a)
        return place{by_b.face, after(by_b.corner)};
      by_b = next_around(by_b);
      if (by_b.face == first_b.face) break;
    }
  }
  return std::nullopt;
}

// Returns the same edge as an edge of the face on its other side.
delaunay_triangulation::place delaunay_triangulation::other_side(const place& p) const {
  const face& f = faces_[p.face];
  const std::uint32_t other = f.across[p.corner];
  return {other, before(corner_of(faces_[other], f.corner[before(p.corner)]))};
}

void delaunay_triangulation::put(std::uint32_t f, const face& what) {
  faces_[f] = what;
  for (const vertex_index v : what.corner) face_at_[v] = f;
}

void delaunay_triangulation::relink(std::uint32_t neighbour, std::uint32_t old_face,
                                    std::uint32_t new_face) {
  if (neighbour == none) return;
  for (std::uint32_t& f : faces_[neighbour].across)
    if (f == old_face) f = new_face;
}

// Rotates the corners of the face so that this corner comes first.
void delaunay_triangulation::turn_to_front(const place& p) {
  face& f = faces_[p.face];
  const auto by = static_cast<std::ptrdiff_t>(p.corner);
  std::rotate(f.corner.begin(), f.corner.begin() + by, f.corner.end());
  std::rotate(f.across.begin(), f.across.begin() + by, f.across.end());
  std::rotate(f.fixed.begin(), f.fixed.begin() + by, f.fixed.end());
}

delaunay_triangulation::way delaunay_triangulation::way_to(const point& q, std::uint32_t at,
                                                           std::uint32_t from) const {
  const face& f = faces_[at];
  way found;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (f.across[i] == from && from != none) continue;  // q is on this side of it
    const sign side = turn(f.corner[after(i)], f.corner[before(i)], q);
    if (side == sign::negative) return {true, i, 0};
    if (side != sign::zero) continue;
    ++found.touched;
    found.edge = i;
  }
  return found;
}

// Walks towards v from the last face. In a Delaunay triangulation every such walk
// ends.
std::optional<delaunay_triangulation::place> delaunay_triangulation::locate(vertex_index v,
                                                                            bool& on_edge) {
  std::uint32_t at = last_, from = none;
  while (take_step()) {
    const way next = way_to(sites_[v].position, at, from);
    if (!next.goes_on) {
      on_edge = next.touched == 1;
      if (next.touched > 1) return std::nullopt;  // v is at a corner
      return place{at, next.edge};
    }
    from = std::exchange(at, faces_[at].across[next.edge]);
    if (at == none) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<delaunay_triangulation::location> delaunay_triangulation::locate_near(
    const point& q, std::uint32_t from) const {
  constexpr int most_steps = 64;
  std::uint32_t at = from, last = none;
  for (int step = 0; step < most_steps; ++step) {
    const way next = way_to(q, at, last);
    const face& f = faces_[at];
    if (!next.goes_on) {
      if (next.touched > 1 || (next.touched == 1 && f.fixed[next.edge])) return std::nullopt;
      return location{{at, next.edge}, next.touched == 1};
    }
    if (f.fixed[next.edge]) return std::nullopt;
    last = std::exchange(at, f.across[next.edge]);
    if (at == none) return std::nullopt;
  }
  return std::nullopt;
}

// Makes the new faces with v as their first corner.
void delaunay_triangulation::split_face(std::uint32_t f, vertex_index v) {
  const auto [corner, across, fixed] = faces_[f];
  const auto [a, b, c] = corner;
  const auto g = static_cast<std::uint32_t>(faces_.size()), h = g + 1;
  faces_.resize(faces_.size() + 2);
  put(f, {{v, a, b}, {across[2], g, h}, {fixed[2], false, false}});
  put(g, {{v, b, c}, {across[0], h, f}, {fixed[0], false, false}});
  put(h, {{v, c, a}, {across[1], f, g}, {fixed[1], false, false}});
  relink(across[0], f, g);
  relink(across[1], f, h);
  open_.assign({f, g, h});
}

void delaunay_triangulation::split_edge(const place& p, vertex_index v) {
  turn_to_front(p);
  const std::uint32_t f = p.face, o = faces_[f].across[0];
  const face first = faces_[f];
  const auto [a, b, c] = first.corner;
  turn_to_front({o, before(corner_of(faces_[o], c))});
  const face second = faces_[o];  // d, c, b
  const vertex_index d = second.corner[0];
  const auto g = static_cast<std::uint32_t>(faces_.size()), h = g + 1;
  faces_.resize(faces_.size() + 2);
  const bool stays = first.fixed[0];
  put(f, {{v, a, b}, {first.across[2], h, g}, {first.fixed[2], stays, false}});
  put(g, {{v, c, a}, {first.across[1], f, o}, {first.fixed[1], false, stays}});
  put(o, {{v, d, c}, {second.across[2], g, h}, {second.fixed[2], stays, false}});
  put(h, {{v, b, d}, {second.across[1], o, f}, {second.fixed[1], false, stays}});
  relink(first.across[1], f, g);
  relink(second.across[1], o, h);
  open_.assign({f, g, o, h});  // the first two on the corner's side
}

// Flips the edge across from the corner v to the edge from v to the corner d on the other side; v
// becomes the first corner of both faces.
void delaunay_triangulation::flip(const place& p) {
  const std::uint32_t f = p.face, i = p.corner, o = faces_[f].across[i];
  const face first = faces_[f], second = faces_[o];
  const vertex_index v = first.corner[i], a = first.corner[after(i)], b = first.corner[before(i)];
  const std::uint32_t j = before(corner_of(second, b));
  const vertex_index d = second.corner[j];  // before b and a
  faces_[f] = {{v, a, d},
               {second.across[after(j)], o, first.across[before(i)]},
               {second.fixed[after(j)], false, first.fixed[before(i)]}};
  faces_[o] = {{v, d, b},
               {second.across[before(j)], first.across[after(i)], f},
               {second.fixed[before(j)], first.fixed[after(i)], false}};
  face_at_[a] = f;
  face_at_[v] = face_at_[d] = face_at_[b] = o;
  relink(second.across[after(j)], o, f);
  relink(first.across[after(i)], f, o);
}

// Makes the edges around the faces in open_, which all have v first, Delaunay.
bool delaunay_triangulation::flip_around(vertex_index v) {
  while (!open_.empty()) {
    if (!take_step()) return false;
    const std::uint32_t f = open_.back();
    open_.pop_back();
    const place p{f, corner_of(faces_[f], v)};
    if (stays(p, *kernel_)) continue;
    const std::uint32_t other = faces_[f].across[p.corner];
    flip(p);
    open_.push_back(f);
    open_.push_back(other);
  }
  return true;
}

bool delaunay_triangulation::insert(vertex_index v) {
  if (!is_framed_) return false;
  bool on_edge = false;
  const auto where = locate(v, on_edge);
  if (!where) return false;
  if (on_edge)
    split_edge(*where, v);
  else
    split_face(where->face, v);
  last_ = where->face;
  return flip_around(v);
}

// Lists the edges of the changed face, which are to be tested.
void delaunay_triangulation::suspect(const face& f) {
  for (std::uint32_t i = 0; i < 3; ++i) suspects_.emplace_back(f.corner[i], f.corner[after(i)]);
}

// Marks the edge as one that stays; returns false if there is no such edge.
bool delaunay_triangulation::fix(vertex_index a, vertex_index b) {
  const auto left = find_edge(a, b);
  if (!left || faces_[left->face].across[left->corner] == none) return false;
  const place right = other_side(*left);
  faces_[left->face].fixed[left->corner] = true;
  faces_[right.face].fixed[right.corner] = true;
  return true;
}

// Collects the edges that the segment from a to b crosses, in order.
bool delaunay_triangulation::cross(vertex_index a, vertex_index b,
                                   std::vector<std::pair<vertex_index, vertex_index>>& crossed) {
  const place first = at(a);
  place p = first;
  for (;; p = next_around(p)) {
    if (p.face == none || !take_step()) return false;
    const face& f = faces_[p.face];
    const sign right = turn(a, f.corner[after(p.corner)], b),
               left = turn(a, f.corner[before(p.corner)], b);
    if (right == sign::positive && left == sign::negative) break;
    if (next_around(p).face == first.face) return false;
  }
  while (take_step()) {
    const face& f = faces_[p.face];
    if (f.fixed[p.corner] || f.across[p.corner] == none) return false;
    const vertex_index right = f.corner[after(p.corner)], left = f.corner[before(p.corner)];
    crossed.emplace_back(right, left);
    const std::uint32_t next = f.across[p.corner];
    const face& o = faces_[next];
    const vertex_index apex = o.corner[after(corner_of(o, right))];
    if (apex == b) return true;
    const sign side = turn(a, b, apex);
    if (side == sign::zero) return false;  // the segment goes through a site
    // Continues on the far side, in the next face that the segment enters.
    p = {next, corner_of(o, side == sign::positive ? left : right)};
  }
  return false;
}

// Flips the edges that cross the segment from a to b until none does.
bool delaunay_triangulation::clear_way(
    vertex_index a, vertex_index b, std::vector<std::pair<vertex_index, vertex_index>> crossing) {
  for (std::size_t i = 0; i < crossing.size(); ++i) {
    if (!take_step()) return false;
    const auto [p, q] = crossing[i];
    const auto found = find_edge(p, q);
    if (!found) return false;
    const place back = other_side(*found);
    const vertex_index x = faces_[found->face].corner[found->corner],
                       y = faces_[back.face].corner[back.corner];
    if (turn(x, p, y) != sign::positive || turn(x, y, q) != sign::positive) {
      crossing.emplace_back(p, q);  // the two faces are no convex quadrangle yet
      continue;
    }
    flip(*found);
    suspect(faces_[found->face]);
    suspect(faces_[back.face]);
    const bool at_end = x == a || x == b || y == a || y == b;
    if (!at_end && turn(a, b, x) * turn(a, b, y) == sign::negative) crossing.emplace_back(x, y);
  }
  return true;
}

bool delaunay_triangulation::insert_segment(vertex_index a, vertex_index b) {
  if (fix(a, b)) return true;
  std::vector<std::pair<vertex_index, vertex_index>> crossed;
  return cross(a, b, crossed) && clear_way(a, b, std::move(crossed)) && fix(a, b);
}

bool delaunay_triangulation::settle() {
  while (!suspects_.empty()) {
    if (!take_step()) return false;
    const auto [a, b] = suspects_.back();
    suspects_.pop_back();
    const auto p = find_edge(a, b);
    if (!p || stays(*p, *kernel_)) continue;
    const std::uint32_t other = faces_[p->face].across[p->corner];
    flip(*p);
    suspect(faces_[p->face]);
    suspect(faces_[other]);
  }
  return true;
}

// True if is_better prefers the other diagonal, the edge across from the corner is not fixed, and
// the faces on both sides form a convex quadrangle.
bool delaunay_triangulation::may_flip(const place& p, const comparison& is_better) const {
  const face& f = faces_[p.face];
  if (f.across[p.corner] == none || f.fixed[p.corner]) return false;
  const place back = other_side(p);
  const vertex_index c = f.corner[p.corner], a = f.corner[after(p.corner)],
                     b = f.corner[before(p.corner)], d = faces_[back.face].corner[back.corner];
  return is_better(a, b, c, d) && turn(c, a, d) == sign::positive &&
         turn(c, d, b) == sign::positive;
}

// Flips one edge of the face if is_better prefers the other diagonal of some edge; returns false
// otherwise. Adds the faces on both sides to open_. Leaves out edges to faces before `first`.
bool delaunay_triangulation::improve(std::uint32_t at, std::uint32_t first,
                                     const comparison& is_better) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t other = faces_[at].across[i];
    if (other < first || !may_flip({at, i}, is_better)) continue;
    flip({at, i});
    open_.push_back(other);
    open_.push_back(at);
    return true;
  }
  return false;
}

bool delaunay_triangulation::flip_towards(const comparison& is_better, std::size_t most) {
  std::size_t flips = 0;
  open_.clear();
  // Skips edges to faces before f: they were tested from there, and again after each change.
  for (std::uint32_t f = 0; f < faces_.size() && flips < most; ++f) {
    if (improve(f, f, is_better)) ++flips;
    while (!open_.empty() && flips < most) {
      const std::uint32_t at = open_.back();
      open_.pop_back();
      if (improve(at, 0, is_better)) ++flips;
    }
  }
  return flips < most;
}

vertex_index delaunay_triangulation::add_site(const site& s) {
  const auto v = static_cast<vertex_index>(sites_.size());
  sites_.push_back(s);
  face_at_.push_back(none);
  return v;
}

vertex_index delaunay_triangulation::insert_towards(const site& s, const location& at,
                                                    const comparison& is_better, std::size_t most) {
  const vertex_index v = add_site(s);
  if (at.on_edge)
    split_edge(at.where, v);
  else
    split_face(at.where.face, v);
  flip_around_towards(v, is_better, most);
  return v;
}

vertex_index delaunay_triangulation::split_towards(const site& s, const place& at,
                                                   bool on_both_sides, const comparison& is_better,
                                                   std::size_t most) {
  const vertex_index v = add_site(s);
  split_edge(at, v);
  if (!on_both_sides) open_.resize(2);
  flip_around_towards(v, is_better, most);
  return v;
}

// Tests only edges across from the new site: each flip adds two such edges.
void delaunay_triangulation::flip_around_towards(vertex_index v, const comparison& is_better,
                                                 std::size_t most) {
  std::size_t flips = 0;
  while (!open_.empty() && flips < most) {
    const std::uint32_t f = open_.back();
    open_.pop_back();
    const place p{f, corner_of(faces_[f], v)};
    if (!may_flip(p, is_better)) continue;
    const std::uint32_t other = faces_[f].across[p.corner];
    flip(p);
    ++flips;
    open_.push_back(f);
    open_.push_back(other);
  }
  flips_of_insertions_ += flips;
}

}  // namespace asterism::internal
