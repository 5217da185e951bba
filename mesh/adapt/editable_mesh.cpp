// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/editable_mesh.hpp"

#include <algorithm>

#include "asterism/mesh/support/number_present.hpp"

namespace asterism::internal::adapting {

void editable_mesh::around(vertex_index v, face_list& out) const {
  out.clear();
  const vertex_index start = nodes_[v].face;
  vertex_index t = start;
  do {
    out.push_back(t);
    t = faces_[t].next[after(faces_[t].corner_of(v))];
  } while (t != none && t != start);
  if (t == start) return looked_at_.add(out.size());
  face_list earlier;
  for (t = faces_[start].next[before(faces_[start].corner_of(v))]; t != none;
       t = faces_[t].next[before(faces_[t].corner_of(v))])
    earlier.push_back(t);
  std::reverse(earlier.begin(), earlier.end());
  out.insert(out.begin(), earlier.begin(), earlier.end());
  looked_at_.add(out.size());
}

void editable_mesh::neighbours(vertex_index v, face_list& out) const {
  face_list at;
  around(v, at);
  out.clear();
  for (const vertex_index t : at) out.push_back(faces_[t].v[after(faces_[t].corner_of(v))]);
  const face& last = faces_[at.back()];
  const std::size_t i = last.corner_of(v);
  if (last.next[after(i)] == none) out.push_back(last.v[before(i)]);
}

vertex_index editable_mesh::new_face() {
  if (free_faces_.empty()) {
    faces_.emplace_back();
    return static_cast<vertex_index>(faces_.size() - 1);
  }
  const vertex_index t = free_faces_.back();
  free_faces_.pop_back();
  return t;
}

vertex_index editable_mesh::new_node(const point& where, node_kind kind) {
  node made;
  made.position = where;
  made.kind = kind;
  nodes_.push_back(made);
  ++count_;
  return static_cast<vertex_index>(nodes_.size() - 1);
}

void editable_mesh::set(vertex_index t, const std::array<vertex_index, 3>& v,
                        const std::array<vertex_index, 3>& next,
                        const std::array<vertex_index, 3>& segment) {
  faces_[t] = {v, next, segment};
  for (const vertex_index u : v) nodes_[u].face = t;
}

void editable_mesh::replace_neighbour(vertex_index t, vertex_index old, vertex_index now) {
  if (t == none) return;
  for (vertex_index& n : faces_[t].next)
    if (n == old) {
      n = now;
      return;
    }
}

std::optional<vertex_index> editable_mesh::split(vertex_index t, std::size_t edge,
                                                 const point& where) {
  const face f = faces_[t];
  const vertex_index c = f.v[edge], a = f.v[after(edge)], b = f.v[before(edge)], s = f.next[edge];
  const auto fits = [&](vertex_index x, vertex_index y, vertex_index z) {
    return turns_left(nodes_[x].position, nodes_[y].position, where) &&
           turns_left(nodes_[y].position, nodes_[z].position, where);
  };
  // Makes the faces around the new node: (c, a, m), (b, c, m), and across (d, b, m), (a, d, m).
  if (!fits(b, c, a)) return std::nullopt;
  vertex_index d = none;
  std::size_t j = 0;
  if (s != none) {
    j = after(faces_[s].corner_of(a));
    d = faces_[s].v[j];
    if (!fits(a, d, b)) return std::nullopt;
  }
  const vertex_index subsegment = f.segment[edge];
  const vertex_index m = new_node(where, subsegment == none ? node_kind::free : node_kind::sliding);
  nodes_[m].segment = subsegment;
  const vertex_index t2 = new_face();
  const vertex_index ca = f.next[before(edge)], bc = f.next[after(edge)];
  if (s == none) {
    set(t, {c, a, m}, {none, t2, ca}, {subsegment, none, f.segment[before(edge)]});
    set(t2, {c, m, b}, {none, bc, t}, {subsegment, f.segment[after(edge)], none});
    replace_neighbour(bc, t, t2);
    return m;
  }
  const face g = faces_[s];
  const vertex_index s2 = new_face();
  const vertex_index db = g.next[before(j)], ad = g.next[after(j)];
  set(t, {c, a, m}, {s2, t2, ca}, {subsegment, none, f.segment[before(edge)]});
  set(t2, {c, m, b}, {s, bc, t}, {subsegment, f.segment[after(edge)], none});
  set(s, {d, b, m}, {t2, s2, db}, {subsegment, none, g.segment[before(j)]});
  set(s2, {d, m, a}, {t, ad, s}, {subsegment, g.segment[after(j)], none});
  replace_neighbour(bc, t, t2);
  replace_neighbour(ad, s, s2);
  return m;
}

located_place editable_mesh::locate(const point& q, vertex_index from, walls at) const {
  vertex_index t = from;
  const std::size_t most = 100 + faces_.size();
  for (std::size_t step = 0; step < most; ++step) {
    const face& f = faces_[t];
    vertex_index next = t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + step) % 3;
      const point &a = nodes_[f.v[after(i)]].position, &b = nodes_[f.v[before(i)]].position;
      if ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x) >= 0) continue;
      if (f.next[i] == none || (at == walls::segments && f.segment[i] != none)) return {t, i};
      next = f.next[i];
      break;
    }
    if (next == t) return {t, std::nullopt};
    t = next;
  }
  return {};
}

std::optional<vertex_index> editable_mesh::insert(vertex_index t, const point& where) {
  const face f = faces_[t];
  for (std::size_t i = 0; i < 3; ++i)
    if (!turns_left(nodes_[f.v[i]].position, nodes_[f.v[after(i)]].position, where))
      return std::nullopt;
  const vertex_index m = new_node(where, node_kind::free);
  const vertex_index t1 = new_face(), t2 = new_face();
  const auto [a, b, c] = f.v;
  set(t, {a, b, m}, {t1, t2, f.next[2]}, {none, none, f.segment[2]});
  set(t1, {b, c, m}, {t2, t, f.next[0]}, {none, none, f.segment[0]});
  set(t2, {c, a, m}, {t, t1, f.next[1]}, {none, none, f.segment[1]});
  replace_neighbour(f.next[0], t, t1);
  replace_neighbour(f.next[1], t, t2);
  return m;
}

bool editable_mesh::can_flip(vertex_index t, std::size_t edge) const {
  const face& f = faces_[t];
  const vertex_index s = f.next[edge];
  if (s == none || f.segment[edge] != none) return false;
  const vertex_index c = f.v[edge], a = f.v[after(edge)], b = f.v[before(edge)];
  const vertex_index d = faces_[s].v[after(faces_[s].corner_of(a))];
  return turns_left(nodes_[c].position, nodes_[a].position, nodes_[d].position) &&
         turns_left(nodes_[d].position, nodes_[b].position, nodes_[c].position);
}

void editable_mesh::flip(vertex_index t, std::size_t edge) {
  const face f = faces_[t];
  const vertex_index s = f.next[edge];
  const face g = faces_[s];
  const vertex_index c = f.v[edge], a = f.v[after(edge)], b = f.v[before(edge)];
  const std::size_t j = after(g.corner_of(a));
  const vertex_index d = g.v[j];
  const vertex_index bc = f.next[after(edge)], ca = f.next[before(edge)];
  const vertex_index ad = g.next[after(j)], db = g.next[before(j)];
  set(t, {c, a, d}, {ad, s, ca}, {g.segment[after(j)], none, f.segment[before(edge)]});
  set(s, {d, b, c}, {bc, t, db}, {f.segment[after(edge)], none, g.segment[before(j)]});
  replace_neighbour(ad, s, t);
  replace_neighbour(bc, t, s);
}

// True if the merge removes no given node and no segment: a sliding node may only be merged along
// its segment.
bool editable_mesh::merge_is_allowed(vertex_index v, vertex_index w, const face_list& at) const {
  const node& from = nodes_[v];
  if (from.kind == node_kind::free) return true;
  if (from.kind != node_kind::sliding) return false;
  return std::any_of(at.begin(), at.end(), [&](vertex_index t) {
    const face& f = faces_[t];
    for (std::size_t i = 0; i < 3; ++i)
      if (f.segment[i] != none && f.v[i] != v && f.v[i] != w &&
          (f.v[after(i)] == w || f.v[before(i)] == w))
        return true;
    return false;
  });
}

bool editable_mesh::can_merge(vertex_index v, vertex_index w) const {
  face_list at;
  around(v, at);
  return can_merge(v, w, at);
}

bool editable_mesh::can_merge(vertex_index v, vertex_index w, const face_list& at) const {
  if (!merge_is_allowed(v, w, at)) return false;
  std::size_t stay = 0;
  for (const vertex_index t : at) {
    const face& f = faces_[t];
    const std::size_t i = f.corner_of(v);
    const vertex_index a = f.v[after(i)], b = f.v[before(i)];
    if (a == w || b == w) continue;
    ++stay;
    if (!turns_left(nodes_[w].position, nodes_[a].position, nodes_[b].position)) return false;
  }
  return stay > 0;
}

void editable_mesh::merge(vertex_index v, vertex_index w) {
  face_list at;
  around(v, at);
  for (const vertex_index t : at) {
    const face f = faces_[t];
    const std::size_t i = f.corner_of(v);
    if (f.v[after(i)] != w && f.v[before(i)] != w) {
      faces_[t].v[i] = w;
      nodes_[w].face = t;
      continue;
    }
    // Removes the face of v, w and a third node, and joins the faces beyond its other two edges:
    // both now share the edge from w to the third node.
    const std::size_t k = f.corner_of(w);
    const vertex_index beyond_v = f.next[i], beyond_w = f.next[k];
    const vertex_index third = f.v[3 - i - k];
    const vertex_index subsegment = f.segment[i] != none ? f.segment[i] : f.segment[k];
    for (const auto& [here, other] : {std::pair(beyond_v, beyond_w), {beyond_w, beyond_v}}) {
      if (here == none) continue;
      for (std::size_t e = 0; e < 3; ++e)
        if (faces_[here].next[e] == t) {
          faces_[here].next[e] = other;
          faces_[here].segment[e] = subsegment;
        }
      nodes_[third].face = here;
    }
    if (beyond_v != none) nodes_[w].face = beyond_v;
    faces_[t] = {};
    free_faces_.push_back(t);
  }
  nodes_[v].kind = node_kind::gone;
  --count_;
}

bool editable_mesh::can_move(vertex_index v, const point& where) const {
  face_list at;
  around(v, at);
  return std::all_of(at.begin(), at.end(), [&](vertex_index t) {
    const face& f = faces_[t];
    const std::size_t i = f.corner_of(v);
    return turns_left(where, nodes_[f.v[after(i)]].position, nodes_[f.v[before(i)]].position);
  });
}

point editable_mesh::on_segment(vertex_index v, const point& where) const {
  if (curves_->is_chord(nodes_[v].segment))
    return curves_->nearest(nodes_[v].segment, where).value_or(nodes_[v].position);
  const segment& s = domain_->segments[nodes_[v].segment];
  const point &a = domain_->vertices[s.a], &b = domain_->vertices[s.b];
  const double x = b.x - a.x, y = b.y - a.y;
  const double along = ((where.x - a.x) * x + (where.y - a.y) * y) / (x * x + y * y);
  return {a.x + along * x, a.y + along * y};
}

std::optional<point> editable_mesh::place_on_edge(vertex_index t, std::size_t edge,
                                                  const point& where) const {
  const vertex_index segment = faces_[t].segment[edge];
  return curves_->is_chord(segment) ? curves_->nearest(segment, where) : where;
}

editable_mesh::parts editable_mesh::release() {
  free_faces_.clear();
  count_ = 0;
  return {std::exchange(nodes_, {}), std::exchange(faces_, {})};
}

void editable_mesh::assign(parts p) {
  nodes_ = std::move(p.nodes);
  faces_ = std::move(p.faces);
  free_faces_.clear();
  for (vertex_index t = 0; t < faces_.size(); ++t)
    if (!faces_[t].exists()) free_faces_.push_back(t);
  count_ = static_cast<std::size_t>(std::count_if(
      nodes_.begin(), nodes_.end(), [](const node& n) { return n.kind != node_kind::gone; }));
}

void editable_mesh::assign_all(parts p) {
  nodes_ = std::move(p.nodes);
  faces_ = std::move(p.faces);
  free_faces_.clear();
  count_ = nodes_.size();
}

editable_mesh editable_mesh::like(parts p) const {
  editable_mesh made(*domain_, curves_);
  made.assign(std::move(p));
  return made;
}

namespace {

static_assert(present_numbers::gone == none);

// A piece of a segment between two nodes, and its place along the segment.
using placed_piece = std::pair<double, boundary_edge>;

// Returns edge i of a face as a piece of its segment. Returns none where the edge is on no segment,
// or runs against its segment: the face across has the piece then.
std::optional<placed_piece> piece_at(const domain& d, const std::vector<node>& nodes, const face& f,
                                     std::size_t i) {
  if (f.segment[i] == none) return std::nullopt;
  const segment& s = d.segments[f.segment[i]];
  const point &a = d.vertices[s.a], &b = d.vertices[s.b];
  const vertex_index u = f.v[after(i)], w = f.v[before(i)];
  const point &p = nodes[u].position, &q = nodes[w].position;
  const double x = b.x - a.x, y = b.y - a.y;
  if ((q.x - p.x) * x + (q.y - p.y) * y < 0) return std::nullopt;
  return placed_piece{(p.x - a.x) * x + (p.y - a.y) * y,
                      {u, w, f.segment[i], s.marker, s.internal}};
}

bool is_before(const placed_piece& p, const placed_piece& q) {
  return p.second.segment != q.second.segment ? p.second.segment < q.second.segment
                                              : p.first < q.first;
}

}  // namespace

mesh editable_mesh::triangulation(std::vector<vertex_index>& renumbered) const {
  const auto is_node = [this](std::size_t v) { return nodes_[v].kind != node_kind::gone; };
  const auto is_face = [this](std::size_t t) { return faces_[t].exists(); };
  present_numbers sites = number_present(nodes_.size(), is_node);
  const present_numbers triangles = number_present(faces_.size(), is_face);
  renumbered = std::move(sites.of);
  mesh made;
  made.given = static_cast<vertex_index>(domain_->vertices.size());
  resize_in_threads(made.sites, sites.count);
  resize_in_threads(made.triangles, triangles.count);
  each_node([&](vertex_index v) {
    made.sites[renumbered[v]] = {nodes_[v].position, nodes_[v].metric};
  });
  const auto take = [&](std::size_t begin, std::size_t end, std::vector<placed_piece>& pieces) {
    for (std::size_t t = begin; t < end; ++t) {
      const face& f = faces_[t];
      for (std::size_t i = 0; f.exists() && i < 3; ++i) {
        made.triangles[triangles.of[t]][i] = renumbered[f.v[i]];
        if (auto piece = piece_at(*domain_, nodes_, f, i)) pieces.push_back(*piece);
      }
    }
  };
  constexpr std::size_t faces_at_once = 4096;  // for a thread
  std::vector<placed_piece> pieces =
      collect_chunks<placed_piece>(faces_.size(), faces_at_once, take);
  std::sort(pieces.begin(), pieces.end(), is_before);
  for (const auto& [place, e] : pieces)
    made.boundary.push_back({renumbered[e.a], renumbered[e.b], e.segment, e.marker, e.internal});
  return made;
}

}  // namespace asterism::internal::adapting
