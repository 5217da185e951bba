// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/flow_meshes.hpp"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {
namespace {

// A string of nodes along the boundary, the domain on its left. A closed string has its first node
// at the end again.
struct node_string {
  int marker = 0;
  std::vector<vertex_index> nodes;

  bool is_closed() const { return nodes.size() > 2 && nodes.front() == nodes.back(); }
};

// Joins edges of one marker end to start, as long as only one begins where another ends.
std::vector<node_string> strings_of(const mesh& m, bool with_internal) {
  std::map<std::pair<int, vertex_index>, std::vector<std::size_t>> starting, ending;
  for (std::size_t e = 0; e < m.boundary.size(); ++e) {
    const boundary_edge& edge = m.boundary[e];
    if (edge.internal && !with_internal) continue;
    starting[{edge.marker, edge.a}].push_back(e);
    ending[{edge.marker, edge.b}].push_back(e);
  }
  std::vector<char> used(m.boundary.size(), 0);
  std::vector<node_string> made;
  const auto goes_on = [&](int marker, vertex_index v) {
    const auto from = starting.find({marker, v}), to = ending.find({marker, v});
    return from != starting.end() && to != ending.end() && from->second.size() == 1 &&
           to->second.size() == 1;
  };
  const auto follow = [&](std::size_t first) {
    node_string s{m.boundary[first].marker, {m.boundary[first].a}};
    for (std::size_t e = first; used[e] == 0;) {
      used[e] = 1;
      s.nodes.push_back(m.boundary[e].b);
      if (!goes_on(s.marker, m.boundary[e].b)) break;
      e = starting.at({s.marker, m.boundary[e].b}).front();
    }
    made.push_back(std::move(s));
  };
  // Lists the open strings, in the order of their first edges, then the closed ones.
  for (const bool closed : {false, true})
    for (std::size_t e = 0; e < m.boundary.size(); ++e) {
      const boundary_edge& edge = m.boundary[e];
      if (used[e] != 0 || (edge.internal && !with_internal)) continue;
      if (closed || !goes_on(edge.marker, edge.a)) follow(e);
    }
  return made;
}

void append_node(std::string& text, vertex_index v) { append_integer(text, std::size_t{v} + 1); }

void append_place(std::string& text, const point& p) {
  append_number(text, p.x);
  append_number(text += ' ', p.y);
  text += " 0\n";
}

// Returns twice the area to the left of a closed string.
double area_of(const mesh& m, const node_string& s) {
  double sum = 0;
  const point& o = m.sites[s.nodes.front()].position;
  for (std::size_t i = 0; i + 1 < s.nodes.size(); ++i) {
    const point &p = m.sites[s.nodes[i]].position, &q = m.sites[s.nodes[i + 1]].position;
    sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return sum;
}

// True if the domain is outside of a string that closes.
bool is_island(const mesh& m, const node_string& s) { return s.is_closed() && area_of(m, s) < 0; }

// Appends the string as lines "NS": ten nodes each, the last one negative, then the marker.
void append_string(std::string& text, const node_string& s) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    if (i % most == 0) text += i == 0 ? "NS" : "\nNS";
    text += i + 1 == s.nodes.size() ? " -" : " ";
    append_node(text, s.nodes[i]);
  }
  append_integer(text += ' ', s.marker);
  text += '\n';
}

}  // namespace

std::string sms_text(const mesh& m) {
  std::string text = "MESH2D\n";
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    append_integer(to += "E3T ", t + 1);
    for (const vertex_index v : m.triangles[t]) append_node(to += ' ', v);
    append_integer(to += ' ', region_of(m, t));
    to += '\n';
  });
  append_lines(text, m.sites.size(), [&](std::size_t v, std::string& to) {
    append_integer(to += "ND ", v + 1);
    append_place(to += ' ', m.sites[v].position);
  });
  for (const node_string& s : strings_of(m, true)) append_string(text, s);
  return text;
}

std::string adcirc_text(const mesh& m, const physical_names& names, const std::string& title) {
  std::string text = title.empty() ? "mesh" : title.substr(0, title.find('\n'));
  text += '\n';
  append_integer(text, m.triangles.size());
  append_integer(text += ' ', m.sites.size());
  text += '\n';
  append_lines(text, m.sites.size(), [&](std::size_t v, std::string& to) {
    append_integer(to, v + 1);
    append_place(to += ' ', m.sites[v].position);
  });
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    append_integer(to, t + 1);
    to += " 3";
    for (const vertex_index v : m.triangles[t]) append_node(to += ' ', v);
    to += '\n';
  });
  const std::vector<node_string> strings = strings_of(m, false);
  std::size_t nodes = 0;
  for (const node_string& s : strings) nodes += s.nodes.size() - (is_island(m, s) ? 1 : 0);
  text += "0 = Number of open boundaries\n0 = Total number of open boundary nodes\n";
  append_integer(text, strings.size());
  append_integer(text += " = Number of land boundaries\n", nodes);
  text += " = Total number of land boundary nodes\n";
  for (const node_string& s : strings) {
    const bool closes = is_island(m, s);
    const std::size_t count = s.nodes.size() - (closes ? 1 : 0);
    append_integer(text, count);
    text += closes ? " 1 = " : " 0 = ";
    const auto named = names.markers.find(s.marker);
    text += named != names.markers.end() ? named->second : "marker " + std::to_string(s.marker);
    text += '\n';
    for (std::size_t i = 0; i < count; ++i) {
      append_node(text, s.nodes[i]);
      text += '\n';
    }
  }
  return text;
}

}  // namespace asterism::internal
