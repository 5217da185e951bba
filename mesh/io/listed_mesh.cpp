// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/listed_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/renumbering.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/io/clockwise_triangles.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

error refuse(const listed_mesh& m, std::size_t line, const std::string& what) {
  return {fmt::format("{}:{}: {}", m.file, line, what), error_code::malformed_file};
}

std::string place(const mesh& m, vertex_index v) {
  const point& p = m.sites[v].position;
  return fmt::format("({:g}, {:g})", p.x, p.y);
}

// Returns a number with its noun: "1 vertex", "3 vertices".
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

double extent(const mesh& m) {
  const bounding_box box = box_of_sites(m.sites);
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

// Removes heights that are rounding, or equal for all vertices.
failure flatten(listed_mesh& m) {
  if (m.heights.empty()) return {};
  const double common = m.heights.size() == m.content.sites.size() ? m.heights.front().z : 0;
  const double allowed = rounding_of_heights * extent(m.content);
  double most = 0;
  for (const listed_height& h : m.heights) {
    const double off = std::abs(h.z - common);
    if (!(off <= allowed))
      return refuse(m, h.line,
                    fmt::format("z of a vertex: vertex {} has {}, which is not {}: only plane "
                                "meshes can be read, parallel to x and y",
                                h.vertex + 1, number_text(h.z), number_text(common)));
    most = std::max(most, off);
  }
  if (common != 0)
    m.content.notes.push_back(fmt::format(
        "all vertices are at the height z = {}, which is left out", number_text(common)));
  if (most > 0)
    m.content.notes.push_back(fmt::format(
        "heights of up to {:.3g} are taken for rounding and left out: {}, the first: vertex {}",
        most, m.heights.size(), m.heights.front().vertex + 1));
  return {};
}

void add_triangle(mesh& m, const triangle& t, int region, bool has_regions) {
  m.triangles.push_back(t);
  if (has_regions) m.regions.push_back(region);
}

double squared_length(const mesh& m, vertex_index a, vertex_index b) {
  const point &p = m.sites[a].position, &q = m.sites[b].position;
  return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
}

sign orientation(const mesh& m, vertex_index a, vertex_index b, vertex_index c) {
  return filtered_kernel().orientation(m.sites[a].position, m.sites[b].position,
                                       m.sites[c].position);
}

// Splits a quadrilateral along a diagonal with triangles of one orientation on its sides; the
// shorter of two.
failure split(listed_mesh& from, const listed_quadrilateral& quad, bool has_regions) {
  mesh& m = from.content;
  const auto [a, b, c, d] = quad.corners;
  const sign abc = orientation(m, a, b, c), acd = orientation(m, a, c, d);
  const sign abd = orientation(m, a, b, d), bcd = orientation(m, b, c, d);
  const bool by_ac = abc == acd && abc != sign::zero, by_bd = abd == bcd && abd != sign::zero;
  if (!by_ac && !by_bd)
    return refuse(from, quad.line,
                  fmt::format("the quadrilateral of the vertices {}, {}, {} and {} is folded or "
                              "flat: no diagonal splits it into two triangles",
                              a + 1, b + 1, c + 1, d + 1));
  const bool takes_ac = by_ac && (!by_bd || squared_length(m, a, c) <= squared_length(m, b, d));
  add_triangle(m, takes_ac ? triangle{a, b, c} : triangle{a, b, d}, quad.region, has_regions);
  add_triangle(m, takes_ac ? triangle{a, c, d} : triangle{b, c, d}, quad.region, has_regions);
  return {};
}

// Returns the triangle that a quadrilateral with two equal neighbouring corners is.
std::optional<triangle> as_triangle(const std::array<vertex_index, 4>& q) {
  for (std::size_t i = 0; i < 4; ++i)
    if (q[i] == q[(i + 1) % 4]) return triangle{q[i], q[(i + 2) % 4], q[(i + 3) % 4]};
  return std::nullopt;
}

failure split_quadrilaterals(listed_mesh& from) {
  if (from.quadrilaterals.empty()) return {};
  mesh& m = from.content;
  const bool has_regions = m.regions.size() == m.triangles.size();
  std::size_t count = 0;
  for (const listed_quadrilateral& quad : from.quadrilaterals) {
    if (const auto t = as_triangle(quad.corners)) {
      add_triangle(m, *t, quad.region, has_regions);
      continue;
    }
    if (auto failed = split(from, quad, has_regions)) return failed;
    ++count;
  }
  if (count > 0)
    m.notes.push_back(counted(count, "quadrilateral is", "quadrilaterals are") +
                      " split into two triangles each");
  from.quadrilaterals.clear();
  return {};
}

// Returns the triangles in groups by their least vertex, and where each group begins.
struct triangle_groups {
  std::vector<std::size_t> begins, members;
};

triangle_groups by_least_vertex(const mesh& m) {
  triangle_groups made;
  made.members.resize(m.triangles.size());
  made.begins = sort_by_counting(
      m.triangles.size(), m.sites.size(),
      [&m](std::size_t i) {
        const triangle& t = m.triangles[i];
        return std::size_t{*std::min_element(t.begin(), t.end())};
      },
      [&made](std::size_t at, std::size_t t) { made.members[at] = t; });
  return made;
}

triangle sorted(triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

template <class Value>
void keep(std::vector<Value>& all, const std::vector<char>& dropped) {
  if (all.size() != dropped.size()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (dropped[i] == 0) {
      if (kept != i) all[kept] = std::move(all[i]);
      ++kept;
    }
  all.resize(kept);
}

using triangle_pair = std::array<std::size_t, 2>;

// Returns the pairs of triangles with the same vertices: of several, each with the next one.
std::vector<triangle_pair> repeated_triangles(const mesh& m) {
  triangle_groups groups = by_least_vertex(m);
  const auto append = [&](std::size_t first, std::size_t last, std::vector<triangle_pair>& found) {
    for (std::size_t v = first; v < last; ++v) {
      const auto begin = groups.members.begin() + static_cast<std::ptrdiff_t>(groups.begins[v]);
      const auto end = groups.members.begin() + static_cast<std::ptrdiff_t>(groups.begins[v + 1]);
      if (end - begin < 2) continue;
      std::sort(begin, end, [&m](std::size_t s, std::size_t t) {
        const triangle p = sorted(m.triangles[s]), q = sorted(m.triangles[t]);
        return p != q ? p < q : s < t;
      });
      for (auto at = begin + 1; at != end; ++at)
        if (sorted(m.triangles[at[-1]]) == sorted(m.triangles[at[0]]))
          found.push_back({at[-1], at[0]});
    }
  };
  constexpr std::size_t vertices_at_once = 4096;  // for a thread
  return collect_chunks<triangle_pair>(m.sites.size(), vertices_at_once, append);
}

// Removes triangles that are listed again.
failure drop_repeated(listed_mesh& from) {
  mesh& m = from.content;
  const std::vector<triangle_pair> repeated = repeated_triangles(m);
  if (repeated.empty()) return {};
  std::vector<char> again(m.triangles.size(), 0);
  std::size_t first = m.triangles.size();
  for (const auto [s, t] : repeated) {
    if (!m.regions.empty() && m.regions[s] != m.regions[t])
      return error{fmt::format("{}: triangles {} and {} are of the same vertices and in the "
                               "regions {} and {}: take one of them out",
                               from.file, s + 1, t + 1, m.regions[s], m.regions[t]),
                   error_code::invalid_mesh};
    again[t] = 1;
    first = std::min(first, t);
  }
  keep(m.regions, again);
  keep(m.triangles, again);
  m.notes.push_back(counted(repeated.size(), "triangle is", "triangles are") +
                    fmt::format(" listed again and left out, the first: triangle {}", first + 1));
  return {};
}

// Removes the marked edges, and renumbers those that the file requires.
void drop_edges(listed_mesh& from, const std::vector<char>& dropped) {
  std::vector<std::size_t> number(dropped.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < dropped.size(); ++i) number[i] = dropped[i] != 0 ? kept : kept++;
  std::vector<std::size_t> required;
  for (const std::size_t e : from.required_edges)
    if (dropped[e] == 0) required.push_back(number[e]);
  from.required_edges = std::move(required);
  keep(from.content.boundary, dropped);
}

using ends = std::array<vertex_index, 2>;

// Numbers of markers for edges that are in several strings of a solver.
class shared_markers {
 public:
  // Gives the edge a number that stands for its own marker and another one, with the names of both.
  void join(listed_mesh& m, boundary_edge& e, const boundary_edge& other) {
    ++edges_;
    const auto [at, is_new] = together_.emplace(std::pair(e.marker, other.marker), 0);
    if (is_new) {
      at->second = next_number(m);
      auto& names = m.names.markers;
      const std::string first = name_of(names, e.marker), second = name_of(names, other.marker);
      names[at->second] = first + "+" + second;
    }
    e.marker = at->second;
  }
  std::size_t edges() const { return edges_; }

 private:
  int next_number(const listed_mesh& m) {
    if (greatest_ == 0) {
      for (const boundary_edge& e : m.content.boundary) greatest_ = std::max(greatest_, e.marker);
      if (!m.names.markers.empty())
        greatest_ = std::max(greatest_, m.names.markers.rbegin()->first);
    }
    return ++greatest_;
  }
  static std::string name_of(const std::map<int, std::string>& names, int marker) {
    const auto named = names.find(marker);
    return named == names.end() ? std::to_string(marker) : named->second;
  }

  std::map<std::pair<int, int>, int> together_;
  std::size_t edges_ = 0;
  int greatest_ = 0;
};

// Removes edges that are listed again.
failure drop_repeated_edges(listed_mesh& from) {
  mesh& m = from.content;
  std::vector<std::pair<ends, std::size_t>> order;
  order.reserve(m.boundary.size());
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    const boundary_edge& e = m.boundary[i];
    order.push_back({{std::min(e.a, e.b), std::max(e.a, e.b)}, i});
  }
  std::sort(order.begin(), order.end());
  std::vector<char> again(m.boundary.size(), 0);
  shared_markers shared;
  std::vector<std::size_t> first(m.boundary.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::size_t count = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (order[k].first != order[k - 1].first) continue;
    const std::size_t s = order[k - 1].second, t = order[k].second;
    const bool differ = m.boundary[s].marker != m.boundary[t].marker;
    if (differ && from.edges_are_strings)
      shared.join(from, m.boundary[first[s]], m.boundary[t]);
    else if (differ)
      return error{fmt::format("{}: the edge from {} to {} is listed with the markers {} and {}: "
                               "take one of them out",
                               from.file, place(m, m.boundary[s].a), place(m, m.boundary[s].b),
                               m.boundary[s].marker, m.boundary[t].marker),
                   error_code::invalid_mesh};
    again[t] = 1;
    first[t] = first[s];
    ++count;
  }
  if (count == 0) return {};
  // Keeps an edge required, whichever of its lines requires it.
  for (std::size_t& e : from.required_edges) e = first[e];
  drop_edges(from, again);
  m.notes.push_back(counted(count, "edge is", "edges are") + " listed again and left out");
  if (shared.edges() > 0)
    m.notes.push_back("edges that are in several strings have a number for these together: " +
                      std::to_string(shared.edges()));
  return {};
}

void renumber(std::vector<vertex_index>& list, const std::vector<vertex_index>& number) {
  std::size_t kept = 0;
  for (const vertex_index v : list)
    if (number[v] != no_number) list[kept++] = number[v];
  list.resize(kept);
}

void renumber(listed_mesh& from, const std::vector<vertex_index>& number) {
  renumber_vertices(from.content, number);
  renumber(from.marks.corners, number);
  renumber(from.marks.required_vertices, number);
  std::size_t kept = 0;
  for (const ends& e : from.marks.required_edges)
    if (number[e[0]] != no_number && number[e[1]] != no_number)
      from.marks.required_edges[kept++] = {number[e[0]], number[e[1]]};
  from.marks.required_edges.resize(kept);
  kept = 0;
  for (const side_node& s : from.curved)
    if (number[s.a] != no_number && number[s.b] != no_number)
      from.curved[kept++] = {number[s.a], number[s.b], s.at};
  from.curved.resize(kept);
}

// Finds the nodes of sides that are not the middles of their ends. The nodes of two elements at one
// side must coincide.
failure find_curved_sides(listed_mesh& from) {
  const mesh& m = from.content;
  for (const listed_side& s : from.sides)
    from.curved.push_back({std::min(s.a, s.b), std::max(s.a, s.b), m.sites[s.node].position});
  const auto key = [](const side_node& s) { return std::pair(s.a, s.b); };
  std::sort(from.curved.begin(), from.curved.end(), [key](const side_node& p, const side_node& q) {
    return key(p) != key(q) ? key(p) < key(q)
                            : std::pair(p.at.x, p.at.y) < std::pair(q.at.x, q.at.y);
  });
  std::size_t kept = 0;
  for (const side_node& s : from.curved) {
    if (kept > 0 && key(from.curved[kept - 1]) == key(s)) {
      const point& other = from.curved[kept - 1].at;
      if (other == s.at) continue;
      const auto x = numbers_apart(other.x, s.at.x), y = numbers_apart(other.y, s.at.y);
      return error{fmt::format("{}: the side from {} to {} has nodes at ({}, {}) and at ({}, {}): "
                               "elements at one side have to share it",
                               from.file, place(m, s.a), place(m, s.b), x[0], y[0], x[1], y[1]),
                   error_code::invalid_mesh};
    }
    from.curved[kept++] = s;
  }
  from.curved.resize(kept);
  from.curved.erase(std::remove_if(from.curved.begin(), from.curved.end(),
                                   [&m](const side_node& s) {
                                     return s.at == middle_of_side(m.sites[s.a].position,
                                                                   m.sites[s.b].position);
                                   }),
                    from.curved.end());
  return {};
}

// Removes vertices in no triangle, and the edges at them.
void drop_lone_vertices(listed_mesh& from) {
  mesh& m = from.content;
  std::vector<char> lone(m.sites.size(), 1);
  for (const auto* const triangles : {&m.triangles, &m.disagreeing})
    for (const triangle& t : *triangles)
      for (const vertex_index v : t) lone[v] = 0;
  std::vector<char> is_node(m.sites.size(), 0);
  for (const listed_side& s : from.sides) is_node[s.node] = 1;
  std::size_t count = 0;
  vertex_index first = no_number;
  std::vector<vertex_index> number(m.sites.size(), no_number);
  vertex_index next = 0;
  for (vertex_index v = 0; v < number.size(); ++v) {
    if (lone[v] == 0) {
      number[v] = next++;
      continue;
    }
    from.left_out.push_back(v);
    if (is_node[v] == 0 && count++ == 0) first = v;
  }
  if (from.left_out.empty()) return;
  std::vector<char> at_lone(m.boundary.size(), 0);
  std::size_t edges = 0;
  for (std::size_t i = 0; i < m.boundary.size(); ++i)
    if (lone[m.boundary[i].a] != 0 || lone[m.boundary[i].b] != 0) {
      at_lone[i] = 1;
      ++edges;
    }
  drop_edges(from, at_lone);
  if (count > 0)
    m.notes.push_back(counted(count, "vertex", "vertices") + " in no triangle left out" +
                      (edges == 0 ? "" : ", with " + counted(edges, "edge", "edges")) +
                      fmt::format(", the first: vertex {} at {}", first + 1, place(m, first)));
  renumber(from, number);
}

void find_segments(listed_mesh& from) {
  mesh& m = from.content;
  edge_marks marks{std::vector<char>(m.boundary.size(), 0), from.all_edges};
  for (const std::size_t e : from.required_edges) marks.required[e] = 1;
  const triangle_sides sides(m);
  keep_segments(m, sides, marks);
  // Adds missing sides, except for files that list all sides: in such a file a missing side was
  // removed on purpose.
  if (!from.lists_sides) list_sides(m, sides);
}

// Removes edges of strings that are no side of a triangle.
void drop_edges_across(listed_mesh& from) {
  if (!from.edges_are_strings) return;
  mesh& m = from.content;
  const triangle_sides sides(m);
  std::vector<char> across(m.boundary.size(), 0);
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < across.size(); ++i) {
    const boundary_edge& e = m.boundary[i];
    if (sides.find(e.a, e.b) != nullptr || sides.find(e.b, e.a) != nullptr) continue;
    across[i] = 1;
    if (count++ == 0) first = i;
  }
  if (count == 0) return;
  const boundary_edge& e = m.boundary[first];
  m.notes.push_back(counted(count, "edge of a string is no side of a triangle and is",
                            "edges of strings are no sides of triangles and are") +
                    " left out, the first from " + place(m, e.a) + " to " + place(m, e.b));
  drop_edges(from, across);
}

// Replaces references that need more than 32 bits.
void settle(listed_mesh& from) {
  if (from.wide.empty()) return;
  mesh& m = from.content;
  std::vector<int> markers, of_quadrilaterals;
  for (const boundary_edge& e : m.boundary) markers.push_back(e.marker);
  for (const listed_quadrilateral& q : from.quadrilaterals) of_quadrilaterals.push_back(q.region);
  std::string note =
      from.wide.settle({&m.regions, &markers, &m.references, &of_quadrilaterals}, from.names);
  for (std::size_t i = 0; i < markers.size(); ++i) m.boundary[i].marker = markers[i];
  for (std::size_t i = 0; i < of_quadrilaterals.size(); ++i)
    from.quadrilaterals[i].region = of_quadrilaterals[i];
  if (!note.empty()) m.notes.push_back(std::move(note));
}

failure put_right(listed_mesh& m) {
  turn_over_clockwise(m.content, "triangle", 1);
  if (auto failed = drop_repeated(m)) return failed;
  if (auto failed = drop_repeated_edges(m)) return failed;
  drop_edges_across(m);
  drop_lone_vertices(m);
  return {};
}

}  // namespace

std::string note_of_higher_order(std::size_t elements) {
  return counted(elements, "element is", "elements are") +
         " of higher order: taken by their corners, with straight sides between them";
}

std::optional<error> put_in_order(listed_mesh& m, listed_order how) {
  settle(m);
  if (auto failed = flatten(m)) return failed;
  if (m.second_order > 0) m.content.notes.push_back(note_of_higher_order(m.second_order));
  if (auto failed = find_curved_sides(m)) return failed;
  if (auto failed = split_quadrilaterals(m)) return failed;
  if (m.content.triangles.empty() && m.content.disagreeing.empty()) return {};
  if (how == listed_order::put_right)
    if (auto failed = put_right(m)) return failed;
  find_segments(m);
  mesh& made = m.content;
  if (std::all_of(made.regions.begin(), made.regions.end(), [](int r) { return r == 1; }))
    made.regions.clear();
  if (made.references == vertex_references(made)) made.references.clear();
  return {};
}

}  // namespace asterism::internal
