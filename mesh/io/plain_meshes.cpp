// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/plain_meshes.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {
namespace {

void append_point(std::string& text, const point& p) {
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
}

std::string marker_name(int marker, const physical_names& names) {
  const auto named = names.markers.find(marker);
  std::string name = named == names.markers.end() ? std::to_string(marker) : named->second;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace

std::string su2_text(const mesh& m, const physical_names& names) {
  constexpr int line = 3, triangle_type = 5;
  std::string text = "NDIME= 2\nNELEM= ";
  append_words(text, m.triangles.size());
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    const triangle& c = m.triangles[t];
    append_words(to, triangle_type, c[0], c[1], c[2], t);
  });
  text += "NPOIN= ";
  append_words(text, m.sites.size());
  append_lines(text, m.sites.size(), [&](std::size_t v, std::string& to) {
    append_point(to, m.sites[v].position);
    to += ' ';
    append_words(to, v);
  });
  std::map<int, std::vector<boundary_edge>> sides;
  for (const boundary_edge& e : m.boundary)
    if (!e.internal) sides[e.marker].push_back(e);
  text += "NMARK= ";
  append_words(text, sides.size());
  for (const auto& [marker, edges] : sides) {
    text += "MARKER_TAG= " + marker_name(marker, names) +
            "\nMARKER_ELEMS= " + std::to_string(edges.size()) + "\n";
    for (const boundary_edge& e : edges) append_words(text, line, e.a, e.b);
  }
  return text;
}

std::string node_text(const mesh& m) {
  const std::vector<int> markers = vertex_references(m);
  std::string text;
  append_words(text, m.sites.size(), 2, 3, 1);
  append_lines(text, m.sites.size(), [&](std::size_t v, std::string& to) {
    const auto& [position, metric] = m.sites[v];
    append_integer(to, v + 1);
    to += ' ';
    append_point(to, position);
    for (const double entry : {metric.m11, metric.m12, metric.m22}) {
      to += ' ';
      append_number(to, entry);
    }
    to += ' ';
    append_words(to, markers[v]);
  });
  return text;
}

std::string ele_text(const mesh& m) {
  std::string text;
  append_words(text, m.triangles.size(), 3, 1);
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    const triangle& c = m.triangles[t];
    append_words(to, t + 1, std::size_t{c[0]} + 1, std::size_t{c[1]} + 1, std::size_t{c[2]} + 1,
                 region_of(m, t));
  });
  return text;
}

std::string edge_text(const mesh& m) {
  std::string text;
  append_words(text, m.boundary.size(), 1);
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    const boundary_edge& e = m.boundary[i];
    append_words(text, i + 1, std::size_t{e.a} + 1, std::size_t{e.b} + 1, e.marker);
  }
  return text;
}

}  // namespace asterism::internal
