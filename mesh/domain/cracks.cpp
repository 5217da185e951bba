// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "asterism/mesh/data/renumbering.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"
#include "asterism/mesh/support/joined_sets.hpp"
#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism {
namespace {

using namespace internal;

using ends = std::array<vertex_index, 2>;

bool are_in_range(const mesh& m) {
  const auto is_missing = [&m](vertex_index v) { return v >= m.sites.size(); };
  for (const auto* const triangles : {&m.triangles, &m.disagreeing})
    for (const triangle& t : *triangles)
      if (std::any_of(t.begin(), t.end(), is_missing)) return false;
  return std::none_of(m.boundary.begin(), m.boundary.end(),
                      [&](const boundary_edge& e) { return is_missing(e.a) || is_missing(e.b); });
}

struct numbered_point {
  point at;
  vertex_index vertex;
};

// Returns the vertices sorted by place, then number. Sorts copies: the mesh has its vertices in any
// order.
std::vector<numbered_point> sorted_places(const mesh& m) {
  std::vector<numbered_point> order;
  order.reserve(m.sites.size());
  for (const site& s : m.sites)
    order.push_back({s.position, static_cast<vertex_index>(order.size())});
  parallel_sort(order.begin(), order.end(), [](const numbered_point& p, const numbered_point& q) {
    if (p.at.x != q.at.x) return p.at.x < q.at.x;
    return p.at.y != q.at.y ? p.at.y < q.at.y : p.vertex < q.vertex;
  });
  return order;
}

// Returns for each vertex the first one at its place; empty where all places are different.
std::vector<vertex_index> first_at_place(const mesh& m) {
  const std::vector<numbered_point> order = sorted_places(m);
  std::vector<vertex_index> first;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].at != order[i - 1].at) continue;
    if (first.empty()) {
      first.resize(m.sites.size());
      std::iota(first.begin(), first.end(), vertex_index{0});
    }
    first[order[i].vertex] = first[order[i - 1].vertex];
  }
  return first;
}

// Markers of the boundary edges, found by their two ends in either order.
class listed_markers {
 public:
  explicit listed_markers(const mesh& m) {
    for (std::size_t i = 0; i < m.boundary.size(); ++i) {
      const boundary_edge& e = m.boundary[i];
      listed_.push_back({{std::min(e.a, e.b), std::max(e.a, e.b)}, i});
    }
    std::sort(listed_.begin(), listed_.end());
  }
  // Returns the index of the boundary edge; none where it is not listed.
  std::size_t find(vertex_index a, vertex_index b) const {
    const ends key{std::min(a, b), std::max(a, b)};
    const auto at =
        std::lower_bound(listed_.begin(), listed_.end(), key,
                         [](const auto& one, const ends& wanted) { return one.first < wanted; });
    return at != listed_.end() && at->first == key ? at->second : none;
  }
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

 private:
  std::vector<std::pair<ends, std::size_t>> listed_;
};

// An edge of a crack: its sides in the mesh as it was, a -> b with the triangle on the left.
struct crack_edge {
  ends joined;       // first vertices at their places
  ends left, right;  // the right one leads the other way
  std::size_t left_edge, right_edge;
  int left_marker = 0, right_marker = 0;
};

// Finds the edges of cracks: sides without a triangle beyond, for which another such side leads
// back between the same places.
std::vector<crack_edge> find_edges(const mesh& m, const std::vector<vertex_index>& first) {
  const triangle_sides sides(m);
  std::vector<std::pair<ends, ends>> open;  // between places, and between vertices
  for (const auto& s : sides.all()) {
    const auto [a, b] = s.ends;
    if (sides.find(b, a) == nullptr) open.push_back({{first[a], first[b]}, s.ends});
  }
  std::sort(open.begin(), open.end());
  const listed_markers listed(m);
  std::vector<crack_edge> found;
  for (const auto& [joined, left] : open) {
    if (joined[0] >= joined[1]) continue;  // from the other side; of no length, of no slit
    const ends back{joined[1], joined[0]};
    const auto at = std::lower_bound(open.begin(), open.end(), std::pair(back, ends{0, 0}));
    if (at == open.end() || at->first != back) continue;
    crack_edge e{joined, left, at->second, listed.find(left[0], left[1]),
                 listed.find(at->second[0], at->second[1])};
    if (e.left_edge != listed_markers::none) e.left_marker = m.boundary[e.left_edge].marker;
    if (e.right_edge != listed_markers::none) e.right_marker = m.boundary[e.right_edge].marker;
    if (e.left_marker > e.right_marker ||
        (e.left_marker == e.right_marker && e.left_edge > e.right_edge)) {
      std::swap(e.joined[0], e.joined[1]);
      std::swap(e.left, e.right);
      std::swap(e.left_edge, e.right_edge);
      std::swap(e.left_marker, e.right_marker);
    }
    found.push_back(e);
  }
  return found;
}

error at_same_point(const mesh& m, vertex_index v, vertex_index w, const std::string& why,
                    std::size_t first_number) {
  return {fmt::format("vertex {} and vertex {} are at the same point {}, and {}: it "
                      "is no slit. Join them, or take one of them out",
                      std::min(v, w) + first_number, std::max(v, w) + first_number,
                      point_text(m.sites[v].position), why),
          error_code::invalid_mesh};
}

// Refuses vertices at one place that are of one triangle, or that no edge of a crack leads to.
std::optional<error> refuse_others(const mesh& m, const std::vector<vertex_index>& first,
                                   const std::vector<crack_edge>& edges, std::size_t first_number) {
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index v = m.triangles[t][i], w = m.triangles[t][(i + 1) % 3];
      if (v != w && first[v] == first[w])
        return at_same_point(m, v, w,
                             fmt::format("both are corners of triangle {}", t + first_number),
                             first_number);
    }
  std::vector<char> at_crack(m.sites.size(), 0);
  for (const crack_edge& e : edges)
    for (const vertex_index v : e.joined) at_crack[v] = 1;
  for (vertex_index v = 0; v < first.size(); ++v)
    if (first[v] != v && at_crack[first[v]] == 0)
      return at_same_point(m, first[v], v, "no edge that is there twice leads to it", first_number);
  return std::nullopt;
}

// Gives each pair of markers a number for its edges.
std::map<std::pair<int, int>, int> number_pairs(const mesh& m,
                                                const std::vector<crack_edge>& edges) {
  std::vector<char> is_crack(m.boundary.size(), 0);
  std::map<std::pair<int, int>, int> numbers;
  for (const crack_edge& e : edges) {
    numbers[{e.left_marker, e.right_marker}] = 0;
    for (const std::size_t i : {e.left_edge, e.right_edge})
      if (i != listed_markers::none) is_crack[i] = 1;
  }
  std::set<int> taken, of_others;
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    taken.insert(m.boundary[i].marker);
    if (is_crack[i] == 0) of_others.insert(m.boundary[i].marker);
  }
  std::map<int, int> uses;  // pairs that a marker is in
  for (const auto& [pair, number] : numbers) {
    ++uses[pair.first];
    if (pair.second != pair.first) ++uses[pair.second];
  }
  int next = 1;
  for (auto& [pair, number] : numbers) {
    if (pair.first == pair.second && uses[pair.first] == 1 && of_others.count(pair.first) == 0) {
      number = pair.first;
      continue;
    }
    while (taken.count(next) != 0) ++next;
    number = next++;
  }
  return numbers;
}

// Lists each edge of a crack once, in the place of its first side, or at the end.
void list_once(mesh& m, const std::vector<crack_edge>& edges, crack_markers& markers) {
  const auto numbers = number_pairs(m, edges);
  std::vector<char> gone(m.boundary.size(), 0);
  std::vector<boundary_edge> added;
  for (const crack_edge& e : edges) {
    const int number = numbers.at({e.left_marker, e.right_marker});
    markers[number] = {e.left_marker, e.right_marker};
    const std::size_t at = std::min(e.left_edge, e.right_edge);
    boundary_edge one{e.left[0], e.left[1], 0, number, true};
    if (at == listed_markers::none) {
      one.segment = static_cast<vertex_index>(m.boundary.size() + added.size());
      added.push_back(one);
      continue;
    }
    for (const std::size_t i : {e.left_edge, e.right_edge})
      if (i != listed_markers::none) gone[i] = 1;
    gone[at] = 0;
    one.segment = m.boundary[at].segment;
    m.boundary[at] = one;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gone.size(); ++i)
    if (gone[i] == 0) m.boundary[kept++] = m.boundary[i];
  m.boundary.resize(kept);
  m.boundary.insert(m.boundary.end(), added.begin(), added.end());
}

bool is_same(const metric_tensor& a, const metric_tensor& b) {
  return a.m11 == b.m11 && a.m12 == b.m12 && a.m22 == b.m22;
}

// Keeps the first vertex at each place, with a metric at least as fine as the metrics of all
// vertices there, and returns the new numbers.
std::vector<vertex_index> keep_first(mesh& m, const std::vector<vertex_index>& first) {
  std::vector<vertex_index> number(m.sites.size());
  vertex_index kept = 0;
  for (vertex_index v = 0; v < first.size(); ++v) {
    number[v] = first[v] == v ? kept++ : number[first[v]];
    metric_tensor& own = m.sites[first[v]].metric;
    if (!is_same(own, m.sites[v].metric)) own = simultaneous_intersection(own, m.sites[v].metric);
  }
  renumber_vertices(m, number);
  return number;
}

// Lists the sides of a mesh that lists none.
void list_all_sides(mesh& m) {
  if (!m.boundary.empty()) return;
  const triangle_sides sides(m);
  for (const auto& s : sides.all())
    if (sides.find(s.ends[1], s.ends[0]) == nullptr)
      m.boundary.push_back(
          {s.ends[0], s.ends[1], static_cast<vertex_index>(m.boundary.size()), 0, false});
}

// True if each corner of each triangle is a vertex of its own, as where values jump from triangle
// to triangle. All edges would be slits. Two triangles may be the two sides of a slit.
bool are_all_apart(const mesh& m) {
  constexpr std::size_t few = 2;
  if (m.triangles.size() <= few) return false;
  std::vector<char> is_corner(m.sites.size(), 0);
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t)
      if (std::exchange(is_corner[v], char{1}) != 0) return false;
  return true;
}

}  // namespace

result<joined_cracks> join_cracks(mesh& m, int first_number) {
  joined_cracks made;
  if (!are_in_range(m)) return made;
  const std::vector<vertex_index> first = first_at_place(m);
  if (first.empty()) return made;
  if (are_all_apart(m))
    return error{
        "no two triangles have a vertex in common, and corners of several are at one place: "
        "each triangle has vertices of its own; join those at one place",
        error_code::invalid_mesh};
  if (auto refused =
          refuse_others(m, first, find_edges(m, first), static_cast<std::size_t>(first_number)))
    return *refused;
  list_all_sides(m);
  const std::vector<crack_edge> edges = find_edges(m, first);
  list_once(m, edges, made.markers);
  const std::size_t before = m.sites.size();
  made.number = keep_first(m, first);
  made.joined = before - m.sites.size();
  return made;
}

namespace {

// Corners of triangles, joined to fans around their vertices.
class corner_fans {
 public:
  corner_fans(const mesh& m, const triangle_sides& sides, const std::vector<ends>& cracks)
      : m_(m), joined_(3 * m.triangles.size()) {
    for (const auto& s : sides.all()) {
      const auto [a, b] = s.ends;
      if (a > b || std::binary_search(cracks.begin(), cracks.end(), s.ends)) continue;
      const auto* const beyond = sides.find(b, a);
      if (beyond == nullptr) continue;
      for (const vertex_index v : s.ends)
        joined_.join(corner(s.triangle, v), corner(beyond->triangle, v));
    }
  }

  std::size_t corner(vertex_index t, vertex_index v) const {
    const triangle& c = m_.triangles[t];
    return 3 * std::size_t{t} + (c[0] == v ? 0 : c[1] == v ? 1 : 2);
  }
  // Returns the first corner of the fan.
  std::size_t fan(std::size_t c) { return joined_.find(c); }

 private:
  const mesh& m_;
  joined_sets joined_;
};

std::vector<ends> edges_of_cracks(const mesh& m, const crack_markers& cracks) {
  std::vector<ends> edges;
  for (const boundary_edge& e : m.boundary)
    if (e.internal && cracks.count(e.marker) != 0)
      edges.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Gives each fan at a vertex of a crack, except the first, a vertex of its own.
void part_triangles(const mesh& joined, corner_fans& fans, const std::vector<ends>& cracks,
                    parted_mesh& made) {
  mesh& m = made.content;
  std::vector<char> at_crack(joined.sites.size(), 0), is_taken(joined.sites.size(), 0);
  for (const ends& e : cracks)
    for (const vertex_index v : e) at_crack[v] = 1;
  std::map<std::size_t, vertex_index> of_fan;
  for (std::size_t t = 0; t < joined.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index v = joined.triangles[t][i];
      if (at_crack[v] == 0) continue;
      const auto [at, is_new] = of_fan.emplace(fans.fan(3 * t + i), v);
      if (is_new && std::exchange(is_taken[v], 1) != 0) {
        at->second = static_cast<vertex_index>(m.sites.size());
        m.sites.push_back(joined.sites[v]);
        if (!m.references.empty()) m.references.push_back(joined.references[v]);
        made.original.push_back(v);
      }
      m.triangles[t][i] = at->second;
    }
}

}  // namespace

parted_mesh part_cracks(const mesh& joined, const crack_markers& cracks) {
  parted_mesh made{joined, std::vector<vertex_index>(joined.sites.size())};
  std::iota(made.original.begin(), made.original.end(), vertex_index{0});
  const std::vector<ends> edges = edges_of_cracks(joined, cracks);
  if (edges.empty()) return made;
  const triangle_sides sides(joined);
  corner_fans fans(joined, sides, edges);
  part_triangles(joined, fans, edges, made);
  mesh& m = made.content;
  // Returns the side on the left of a -> b, with the present vertices of its triangle.
  const auto side = [&](vertex_index a, vertex_index b) -> std::optional<ends> {
    const auto* const s = sides.find(a, b);
    if (s == nullptr) return std::nullopt;
    const auto at = [&](vertex_index v) {
      return m.triangles[s->triangle][fans.corner(s->triangle, v) % 3];
    };
    return ends{at(a), at(b)};
  };
  const std::size_t listed = m.boundary.size();
  for (std::size_t i = 0; i < listed; ++i) {
    const boundary_edge e = m.boundary[i];
    const auto left = side(e.a, e.b), right = side(e.b, e.a);
    if (left) std::tie(m.boundary[i].a, m.boundary[i].b) = std::pair((*left)[0], (*left)[1]);
    const auto crack = cracks.find(e.marker);
    if (!e.internal || crack == cracks.end() || !left || !right) continue;
    m.boundary[i].internal = false;
    m.boundary[i].marker = crack->second.left;
    m.boundary.push_back({(*right)[0], (*right)[1], e.segment, crack->second.right, false});
  }
  return made;
}

}  // namespace asterism
