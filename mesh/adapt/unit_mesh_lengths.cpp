// SPDX-License-Identifier: MIT
//
// Brings the edges of a unit mesh to their lengths: splits, merges.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/numerics/quick_logarithm.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal::adapting {
namespace {

bool longer(const measured_edge& p, const measured_edge& q) {
  return p.length != q.length ? p.length > q.length : p.a != q.a ? p.a < q.a : p.b < q.b;
}

enum class than { longer, shorter };

// All faces of a mesh, as a list.
struct all_faces {
  explicit all_faces(const editable_mesh& m) : count(m.faces().size()) {}

  std::size_t size() const { return count; }
  vertex_index operator[](std::size_t i) const { return static_cast<vertex_index>(i); }
  bool has(vertex_index) const { return true; }

  std::size_t count;
};

// Some faces of a mesh, listed in ascending order; those that are gone may be among them.
struct some_faces {
  std::size_t size() const { return listed.size(); }
  vertex_index operator[](std::size_t i) const { return listed[i]; }
  bool has(vertex_index t) const { return std::binary_search(listed.begin(), listed.end(), t); }

  const std::vector<vertex_index>& listed;
};

// Returns the edges of these faces that are longer, or shorter, than this, longest first.
template <than Sought, class Faces>
std::vector<measured_edge> edges_where(const editable_mesh& m, double limit, const Faces& faces) {
  m.note_looked_at(faces.size());
  // The length of an edge is between the lengths in the metrics of its ends. So the squares of
  // these alone exclude most edges. Roundings of the squares and of the length are some 1e-16.
  constexpr double roundings = 1e-12;
  const double square = limit * limit;
  const auto may_be_sought = [square](double at_a, double at_b) {
    if constexpr (Sought == than::longer)
      return std::max(at_a, at_b) > square * (1 - roundings);
    else
      return std::min(at_a, at_b) < square * (1 + roundings);
  };
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<measured_edge>& found) {
    for (std::size_t k = begin; k < end; ++k) {
      const vertex_index t = faces[k];
      const face& f = m.faces()[t];
      if (!f.exists()) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index a = f.v[after(i)], b = f.v[before(i)];
        if (a > b && f.next[i] != none && faces.has(f.next[i])) continue;
        const node &p = m.at(a), &q = m.at(b);
        const double x = q.position.x - p.position.x, y = q.position.y - p.position.y;
        if (!may_be_sought(squared(p.metric, x, y), squared(q.metric, x, y))) continue;
        const double length = length_between(p, q);
        if (Sought == than::longer ? length > limit : length < limit)
          found.push_back({length, std::min(a, b), std::max(a, b), t});
      }
    }
  };
  constexpr std::size_t chunk = 4096;
  std::vector<measured_edge> found = collect_chunks<measured_edge>(faces.size(), chunk, append);
  parallel_sort(found.begin(), found.end(), longer);
  return found;
}

// A list of edges in stretches, which several threads examine ahead of the changes of each. Every
// stretch is twice as long as the one before, as in many lists the first few changes are enough.
class stretches {
 public:
  explicit stretches(std::span<const measured_edge> edges) : edges_(edges) {}

  // Moves on to the next stretch if that begins at edge i, and returns whether it does. Must be
  // called for each edge in turn.
  bool moves_on_at(std::size_t i) {
    if (i != begin_ + length_) return false;
    begin_ = i;
    length_ = std::min(next_length_, edges_.size() - i);
    next_length_ *= 2;
    return true;
  }
  // Returns the edges of the present stretch.
  std::span<const measured_edge> present() const { return edges_.subspan(begin_, length_); }
  // Returns the place of edge i in the present stretch.
  std::size_t place_of(std::size_t i) const { return i - begin_; }

 private:
  std::span<const measured_edge> edges_;
  std::size_t begin_ = 0, length_ = 0;  // of the present one; none before the first edge
  std::size_t next_length_ = 1024;      // of the first one
};

// Prefetches faces at the ends of edges that follow edge i of a list, which are anywhere in memory.
void prefetch_faces(const editable_mesh& m, const std::vector<measured_edge>& edges,
                    std::size_t i) {
  if (i + 2 * sites_ahead < edges.size()) {
    const measured_edge& later = edges[i + 2 * sites_ahead];
    prefetch(&m.at(later.a));
    prefetch(&m.faces()[later.face]);
  }
  if (i + sites_ahead >= edges.size()) return;
  const measured_edge& next = edges[i + sites_ahead];
  prefetch(&m.faces()[m.at(next.a).face]);
  for (const vertex_index t : m.faces()[next.face].next)
    if (t != none) prefetch(&m.faces()[t]);
}

// Returns the face with the edge from a to b, and the number of the edge in it.
std::pair<vertex_index, std::size_t> find_edge(const editable_mesh& m, vertex_index a,
                                               vertex_index b) {
  face_list at;
  m.around(a, at);
  for (const vertex_index t : at) {
    const face& f = m.faces()[t];
    const std::size_t i = f.corner_of(a);
    if (f.v[after(i)] == b) return {t, before(i)};
    if (f.v[before(i)] == b) return {t, after(i)};
  }
  return {none, 0};
}

// Returns the number of the edge in the face in which it was found, none if that has changed.
std::optional<std::size_t> edge_of_its_face(const editable_mesh& m, const measured_edge& e) {
  const auto& v = m.faces()[e.face].v;
  for (std::size_t i = 0; i < 3; ++i) {
    const vertex_index a = v[after(i)], b = v[before(i)];
    if ((a == e.a && b == e.b) || (a == e.b && b == e.a)) return i;
  }
  return std::nullopt;
}

// True if the mesh still has the edge.
bool is_edge(const editable_mesh& m, const measured_edge& e) {
  return edge_of_its_face(m, e) || find_edge(m, e.a, e.b).first != none;
}

// Returns the place half way from a to b in a metric that changes geometrically between them.
point middle(const node& a, const node& b) {
  const double x = b.position.x - a.position.x, y = b.position.y - a.position.y;
  const double ratio = std::sqrt(squared(b.metric, x, y) / squared(a.metric, x, y));
  double t = 0.5;
  // Least difference of the ratio from 1 for which the node's place is computed from two
  // logarithms: with x = ratio - 1 it is at 1/2 + x / 8 of the edge, to first order, so that for
  // smaller differences 1/2 has an error below 2e-4.
  constexpr double least_difference = 1e-3;
  if (std::isfinite(ratio) && ratio > 0 && std::abs(ratio - 1) > least_difference)
    t = std::clamp(quick_log((1 + ratio) / 2) / quick_log(ratio), 0.25, 0.75);
  return {a.position.x + t * x, a.position.y + t * y};
}

// Returns the length of an edge in a field: the mean of the lengths by the field's tensors at its
// ends.
double length_in_field(const metric_at& field, const node& a, const node& b, vertex_index& hint_a,
                       vertex_index& hint_b) {
  const double x = b.position.x - a.position.x, y = b.position.y - a.position.y;
  const double at_a = std::sqrt(squared(field(a.position, hint_a), x, y)),
               at_b = std::sqrt(squared(field(b.position, hint_b), x, y));
  return (at_a + at_b) / 2;
}

// Returns those of the edges that are longer than `length` in the field, in order. Tests them with
// several threads: few edges that are long in the mesh's metric are long in the field.
std::vector<measured_edge> longer_in_field(const editable_mesh& m, const metric_at& field,
                                           const std::vector<measured_edge>& edges, double length) {
  constexpr std::size_t edges_at_once = 1024;
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<measured_edge>& longer) {
    for (std::size_t i = begin; i < end; ++i) {
      const node &a = m.at(edges[i].a), &b = m.at(edges[i].b);
      vertex_index hint_a = a.hint, hint_b = b.hint;
      if (length_in_field(field, a, b, hint_a, hint_b) > length) longer.push_back(edges[i]);
    }
  };
  return collect_chunks<measured_edge>(edges.size(), edges_at_once, append);
}

}  // namespace

// Splits edges that are too long in the wanted metric, unless they are short in the mesh's own
// metric, in which stars can agree: where the own metric is coarser, long edges remain.
std::vector<vertex_index> unit_mesh_remesher::split_longer(metric_at wanted,
                                                           const length_limits& limits,
                                                           std::size_t most_nodes) {
  const std::uint32_t before = changes_;
  field_ = std::move(wanted);
  forget_shapes();
  std::vector<measured_edge> found = edges_where<than::longer>(m_, limits.own, all_faces(m_));
  if (mesh_blocks::are_worth_it(m_)) found = longer_in_field(m_, field_, found, limits.wanted);
  for (const measured_edge& e : found) {
    if (m_.count() >= most_nodes) break;
    const auto [t, edge] = find_edge(m_, e.a, e.b);
    if (t == none) continue;
    node &a = m_.at(e.a), &b = m_.at(e.b);
    if (!(length_in_field(field_, a, b, a.hint, b.hint) > limits.wanted)) continue;
    const auto place = m_.place_on_edge(t, edge, middle(a, b));
    const auto made = place ? m_.split(t, edge, *place) : std::nullopt;
    if (!made) continue;
    m_.at(*made).hint = m_.at(e.a).hint;
    measure(*made);
    settle_around(*made);
  }
  std::vector<vertex_index> changed;
  for (vertex_index v = 0; v < node_states_.size(); ++v)
    if (node_states_[v].change > before && m_.at(v).kind != node_kind::gone) changed.push_back(v);
  return changed;
}

std::vector<vertex_index> unit_mesh_remesher::split_left_long(metric_at wanted,
                                                              std::size_t most_nodes) {
  constexpr double most = 1.35, own = 1.2;  // units
  return split_longer(std::move(wanted), {most * unit_, own * unit_}, most_nodes);
}

std::vector<vertex_index> unit_mesh_remesher::split_outliers(metric_at wanted) {
  constexpr double most = 1.5, own = 1.3;  // of the length that the metric itself calls one
  constexpr std::size_t parts = 200;       // of the nodes: the count stays as it is but for these
  const double one = unit_ / crowding_;
  return split_longer(std::move(wanted), {most * one, own * one}, m_.count() + m_.count() / parts);
}

// Returns a node for the place at which an edge is split, with the metric there. Returns none where
// the curve that the edge is a chord of has no place for it.
std::optional<node> unit_mesh_remesher::node_on_edge(const measured_edge& e, vertex_index t,
                                                     std::size_t edge) const {
  const auto place = m_.place_on_edge(t, edge, middle(m_.at(e.a), m_.at(e.b)));
  if (!place) return std::nullopt;
  node there;
  there.position = *place;
  there.hint = m_.at(e.a).hint;
  there.metric = field_(*place, there.hint);
  return there;
}

// Finds the nodes that split a stretch of edges, and looks up the metrics there, by several
// threads. Returns none for an edge that is no longer one of the face in which it was found.
// Returns an empty list in a block, where other threads work on other blocks.
std::vector<std::optional<node>> unit_mesh_remesher::nodes_on_edges(
    std::span<const measured_edge> edges) const {
  if (!mesh_blocks::are_worth_it(m_)) return {};
  constexpr std::size_t edges_at_once = 64;
  std::vector<std::optional<node>> nodes(edges.size());
  parallel_chunks(edges.size(), edges_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                      if (const auto edge = edge_of_its_face(m_, edges[i]))
                        nodes[i] = node_on_edge(edges[i], edges[i].face, *edge);
                  });
  return nodes;
}

// True if the node that splits the edge of t would be so near to the nodes across that it would be
// merged again.
bool unit_mesh_remesher::is_crowded_on_edge(const measured_edge& e, vertex_index t,
                                            std::size_t edge, const node& there) const {
  constexpr double room = 0.55;  // units
  const double least = room * room * unit_ * unit_;
  for (const vertex_index s : {t, m_.faces()[t].next[edge]}) {
    if (s == none) continue;
    const face& g = m_.faces()[s];
    const std::size_t across = g.v[0] != e.a && g.v[0] != e.b   ? 0
                               : g.v[1] != e.a && g.v[1] != e.b ? 1
                                                                : 2;
    const node& n = m_.at(g.v[across]);
    const double x = n.position.x - there.position.x, y = n.position.y - there.position.y;
    if (squared(there.metric, x, y) < least) return true;
  }
  return false;
}

// Splits edges of the listed faces that are longer than `longest`, longest first, until `most` are
// split; null stands for all faces. In a large mesh the metrics at the new nodes are looked up
// ahead, for one stretch of edges at a time.
std::size_t unit_mesh_remesher::split_long(double longest, std::size_t most,
                                           const face_numbers* looked_at) {
  std::size_t done = 0;
  const std::vector<measured_edge> found =
      looked_at == nullptr ? edges_where<than::longer>(m_, longest, all_faces(m_))
                           : edges_where<than::longer>(m_, longest, some_faces{*looked_at});
  std::vector<std::optional<node>> nodes;
  stretches ahead(found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (done >= most || m_.count() >= options_.most_nodes || options_.stop.is_requested())
      return done;
    if (ahead.moves_on_at(i)) nodes = nodes_on_edges(ahead.present());
    prefetch_faces(m_, found, i);
    const measured_edge& e = found[i];
    const auto [t, edge] = find_edge(m_, e.a, e.b);
    if (t == none || !(m_.length(e.a, e.b) > longest)) continue;
    const vertex_index segment = m_.faces()[t].segment[edge];
    if (is_of_frame(segment)) continue;
    const bool is_known = !nodes.empty() && nodes[ahead.place_of(i)];
    const auto there = is_known ? nodes[ahead.place_of(i)] : node_on_edge(e, t, edge);
    if (!there) continue;
    if (e.length < 2 * longest && segment == none && is_crowded_on_edge(e, t, edge, *there))
      continue;
    const auto made = m_.split(t, edge, there->position);
    if (!made) continue;
    m_.at(*made).hint = there->hint;
    m_.set_metric(*made, there->metric);
    settle_around(*made);
    ++done;
  }
  return done;
}

// True if v may be merged into its neighbour w: no edge that this makes is longer than `longest`,
// and no face has a higher energy than is acceptable or than those at v have now.
bool unit_mesh_remesher::is_merge_good(vertex_index v, vertex_index w, double longest) const {
  if (m_.at(v).kind == node_kind::given) return false;
  face_list at;
  m_.around(v, at);
  const auto is_far = [&](vertex_index u) { return u != w && m_.length(w, u) > longest; };
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    if (is_far(f.v[after(f.corner_of(v))])) return false;
  }
  // Adds one more neighbour for the last face at the boundary.
  const face& last = m_.faces()[at.back()];
  if (is_far(last.v[before(last.corner_of(v))])) return false;
  if (!m_.can_merge(v, w, at)) return false;
  constexpr double acceptable = 2.5;
  double most = acceptable;
  for (const vertex_index t : at) most = std::max(most, present_energy(t));
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    const std::size_t i = f.corner_of(v);
    const vertex_index a = f.v[after(i)], b = f.v[before(i)];
    if (a != w && b != w && shape_energy(m_.at(w), m_.at(a), m_.at(b), unit_) > most) return false;
  }
  return true;
}

// True if the edge was tested in vain by the last call of merge_short(), and no face at its ends
// has changed since. Edges must come shortest first; `next` is where the search in merges_in_vain_
// is.
bool unit_mesh_remesher::is_known_in_vain(const measured_edge& e,
                                          std::vector<measured_edge>::const_iterator& next) {
  while (next != merges_in_vain_.end() && longer(e, *next)) ++next;
  return next != merges_in_vain_.end() && !longer(*next, e) && is_unchanged(e, merges_tested_at_);
}

// Tests whether the ends of an edge shorter than `shortest` are to be merged, and which into which.
unit_mesh_remesher::merging unit_mesh_remesher::test_merge(const measured_edge& e,
                                                           double shortest) const {
  if (!is_edge(m_, e) || !(m_.length(e.a, e.b) < shortest)) return merging::not_wanted;
  const double longest = std::numbers::sqrt2 * unit_;
  if (is_merge_good(e.b, e.a, longest)) return merging::second_into_first;
  if (is_merge_good(e.a, e.b, longest)) return merging::first_into_second;
  return merging::in_vain;
}

// Merges v into its neighbour w. Notes a change at v, too: no test of an edge there holds any more.
void unit_mesh_remesher::merge(vertex_index v, vertex_index w) {
  m_.merge(v, w);
  settle_around(w);
  node_state_of(v).change = changes_;
}

// Tests merges of a stretch of edges in the mesh as it is now, by several threads. Returns an empty
// list in a block: there a merge changes the outcome of many tests that follow it.
std::vector<unit_mesh_remesher::merging> unit_mesh_remesher::test_merges(
    std::span<const measured_edge> edges, double shortest) const {
  if (!mesh_blocks::are_worth_it(m_)) return {};
  constexpr std::size_t edges_at_once = 256;
  std::vector<merging> tested(edges.size(), merging::not_wanted);
  parallel_chunks(edges.size(), edges_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                      if (is_mergeable(edges[i])) tested[i] = test_merge(edges[i], shortest);
                  });
  return tested;
}

// Merges edges shorter than this, shortest first, until `most` are merged. In a large mesh they are
// tested ahead, for one stretch of edges at a time.
std::size_t unit_mesh_remesher::merge_short(double shortest, std::size_t most) {
  std::size_t done = 0;
  if (shortest <= 0) return done;  // no edge is: looks at none
  std::vector<measured_edge> found = edges_where<than::shorter>(m_, shortest, all_faces(m_)),
                             in_vain;
  std::reverse(found.begin(), found.end());
  if (merges_tested_by_ != unit_) merges_in_vain_.clear();
  const std::uint32_t begun_at = changes_;
  auto known = merges_in_vain_.cbegin();
  std::vector<merging> tested;
  std::uint32_t tested_at = changes_;
  stretches ahead(found);
  for (std::size_t i = 0; i < found.size() && done < most; ++i) {
    if (ahead.moves_on_at(i)) {
      tested = test_merges(ahead.present(), shortest);
      tested_at = changes_;
    }
    const measured_edge& e = found[i];
    merging now = merging::not_wanted;
    if (!tested.empty() && is_unchanged(e, tested_at))
      now = tested[ahead.place_of(i)];
    else if (is_mergeable(e))
      now = is_known_in_vain(e, known) ? merging::in_vain : test_merge(e, shortest);
    if (now == merging::in_vain) in_vain.push_back(e);
    if (now == merging::in_vain || now == merging::not_wanted) continue;
    const bool is_first = now == merging::first_into_second;
    merge(is_first ? e.a : e.b, is_first ? e.b : e.a);
    ++done;
  }
  merges_in_vain_ = std::move(in_vain);
  merges_tested_at_ = begun_at;
  merges_tested_by_ = unit_;
  return done;
}

}  // namespace asterism::internal::adapting
