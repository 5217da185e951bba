// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <string_view>

#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/gmsh_numbering.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {
namespace {

class gmsh_writer {
 public:
  gmsh_writer(const mesh& m, const gmsh_contents& more) : m_(m), more_(more) {
    const physical_names& names = more.names;
    std::set<int> markers, regions;
    for (const boundary_edge& e : m.boundary) markers.insert(e.marker);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) regions.insert(region_of(m, t));
    curves_ = number_groups(markers, names.markers, "marker");
    surfaces_ = number_groups(regions, names.regions, "region");
  }

  std::string two() {
    text_ = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    text_ += names_of_groups(curves_, surfaces_, m_.given > 0);
    text_ += "$Nodes\n";
    line(m_.sites.size());
    append_lines(text_, m_.sites.size(), [&](std::size_t v, std::string& text) {
      append_integer(text, v + 1);
      text += ' ';
      append_point(text, v);
    });
    text_ += "$EndNodes\n";
    write_elements_of_two();
    write_values();
    return std::move(text_);
  }

  std::string four() {
    text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    text_ += names_of_groups(curves_, surfaces_, m_.given > 0);
    write_entities();
    write_nodes_of_four();
    write_elements_of_four();
    write_values();
    return std::move(text_);
  }

 private:
  template <class... Integers>
  void line(Integers... numbers) {
    append_words(text_, numbers...);
  }
  void append_point(std::string& text, std::size_t v) const {
    append_number(text, m_.sites[v].position.x);
    text += ' ';
    append_number(text, m_.sites[v].position.y);
    text += " 0\n";
  }

  // Writes the box of the whole mesh for each entity: readers of meshes ignore it.
  void write_entities() {
    text_ += "$Entities\n";
    line(std::size_t{m_.given}, curves_.size(), surfaces_.size(), 0);
    for (std::size_t v = 0; v < m_.given; ++v) {
      append_integer(text_, v + 1);
      text_ += ' ';
      append_point(text_, v);
      text_.back() = ' ';
      text_ += "1 1\n";
    }
    const bounding_box box = m_.sites.empty() ? bounding_box{} : box_of_sites(m_.sites);
    for (const auto* all : {&curves_, &surfaces_})
      for (const auto& [number, g] : *all) {
        append_integer(text_, g.entity);
        for (const double x : {box.low.x, box.low.y, 0.0, box.high.x, box.high.y, 0.0}) {
          text_ += ' ';
          append_number(text_, x);
        }
        text_ += " 1 ";
        append_integer(text_, g.tag);
        text_ += " 0\n";
      }
    text_ += "$EndEntities\n";
  }

  void write_nodes_of_four() {
    const std::size_t n = m_.sites.size();
    text_ += "$Nodes\n";
    line(n > 0 ? 1 : 0, n, n > 0 ? 1 : 0, n);
    if (n > 0) {
      line(2, 1, 0, n);
      append_lines(text_, n, [](std::size_t v, std::string& text) { append_words(text, v + 1); });
      append_lines(text_, n, [&](std::size_t v, std::string& text) { append_point(text, v); });
    }
    text_ += "$EndNodes\n";
  }

  int edge_type() const { return more_.nodes == nullptr ? 1 : 8; }
  int triangle_type() const { return more_.nodes == nullptr ? 2 : 9; }

  // Appends number, type and groups of an element of version 2, without the end of the line.
  static void append_words_of(std::string& text, int type, std::size_t tag, int count, int group,
                              std::size_t entity) {
    append_words(text, tag, type, count, group, entity);
    text.pop_back();
  }
  static void append_nodes(std::string& text, std::initializer_list<vertex_index> nodes) {
    for (const vertex_index v : nodes) append_integer(text += ' ', std::size_t{v} + 1);
  }
  void append_edge(std::string& text, std::size_t i) const {
    const boundary_edge& e = m_.boundary[i];
    append_nodes(text, {e.a, e.b});
    if (more_.nodes != nullptr) append_nodes(text, {more_.nodes->of_edges[i]});
    text += '\n';
  }
  void append_triangle(std::string& text, std::size_t t) const {
    const triangle& c = m_.triangles[t];
    append_nodes(text, {c[0], c[1], c[2]});
    if (more_.nodes != nullptr) {
      const auto& on = more_.nodes->of_triangles[t];
      append_nodes(text, {on[0], on[1], on[2]});
    }
    text += '\n';
  }

  std::size_t element_count() const { return m_.given + m_.boundary.size() + m_.triangles.size(); }

  void write_elements_of_two() {
    text_ += "$Elements\n";
    line(element_count());
    std::size_t tag = 0;
    for (std::size_t v = 0; v < m_.given; ++v) line(++tag, 15, 2, 1, v + 1, v + 1);
    for (std::size_t i = 0; i < m_.boundary.size(); ++i) {
      const gmsh_group& g = curves_.at(m_.boundary[i].marker);
      append_words_of(text_, edge_type(), ++tag, 2, g.tag, g.entity);
      append_edge(text_, i);
    }
    append_lines(text_, m_.triangles.size(), [&](std::size_t t, std::string& text) {
      const gmsh_group& g = surfaces_.at(region_of(m_, t));
      append_words_of(text, triangle_type(), tag + t + 1, 2, g.tag, g.entity);
      append_triangle(text, t);
    });
    text_ += "$EndElements\n";
  }

  // Writes a block for each run of elements of one entity, so that elements keep their order.
  void write_elements_of_four() {
    std::string blocks;
    std::swap(blocks, text_);
    std::size_t tag = 0, count = 0;
    for (std::size_t v = 0; v < m_.given; ++v, ++count) {
      line(0, v + 1, 15, 1);
      line(++tag, v + 1);
    }
    write_runs(
        m_.boundary.size(), count, [&](std::size_t i) { return m_.boundary[i].marker; },
        [&](std::size_t i, std::size_t run) {
          if (run > 0) line(1, curves_.at(m_.boundary[i].marker).entity, edge_type(), run);
          append_integer(text_, ++tag);
          append_edge(text_, i);
        });
    write_runs(
        m_.triangles.size(), count, [&](std::size_t t) { return region_of(m_, t); },
        [&](std::size_t t, std::size_t run) {
          if (run > 0) line(2, surfaces_.at(region_of(m_, t)).entity, triangle_type(), run);
          append_integer(text_, ++tag);
          append_triangle(text_, t);
        });
    std::swap(blocks, text_);
    text_ += "$Elements\n";
    line(count, element_count(), element_count() > 0 ? 1 : 0, element_count());
    text_.append(blocks).append("$EndElements\n");
  }

  // Calls write(i, run) in order; `run` is the length of the run that begins there, else 0.
  template <class Number, class Write>
  static void write_runs(std::size_t size, std::size_t& count, const Number& number,
                         const Write& write) {
    for (std::size_t i = 0; i < size;) {
      std::size_t end = i;
      while (end < size && number(end) == number(i)) ++end;
      ++count;
      write(i, end - i);
      for (++i; i < end; ++i) write(i, 0);
    }
  }

  void write_values() {
    if (more_.with_metric) write_metric();
    if (more_.fields == nullptr) return;
    for (const solution_field& field : more_.fields->fields) write_field(field);
  }

  void write_metric() {
    text_ += "$NodeData\n1\n\"metric\"\n1\n0\n3\n0\n9\n";
    line(m_.sites.size());
    append_lines(text_, m_.sites.size(), [&](std::size_t v, std::string& text) {
      const metric_tensor& t = m_.sites[v].metric;
      append_integer(text, v + 1);
      for (const double x : {t.m11, t.m12, 0.0, t.m12, t.m22, 0.0, 0.0, 0.0, 1.0}) {
        text += ' ';
        append_number(text, x);
      }
      text += '\n';
    });
    text_ += "$EndNodeData\n";
  }

  // Replaces quotes and ends of lines, which would end the name.
  static std::string quoted(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '"' || c == '\n' || c == '\r'; }, '_');
    return '"' + name + '"';
  }

  void write_field(const solution_field& field) {
    constexpr std::array<std::size_t, 4> widths = {0, 1, 3, 9};  // in space
    const std::size_t c = components_of(field.kind);
    text_ += "$NodeData\n1\n" + quoted(field.name) + "\n1\n0\n3\n0\n";
    line(widths[c]);
    line(m_.sites.size());
    append_lines(text_, m_.sites.size(), [&](std::size_t v, std::string& text) {
      const double* const x = &field.values[v * c];
      append_integer(text, v + 1);
      const auto append = [&text](std::initializer_list<double> numbers) {
        for (const double number : numbers) append_number(text += ' ', number);
      };
      if (c == 1) append({x[0]});
      if (c == 2) append({x[0], x[1], 0});
      if (c == 3) append({x[0], x[1], 0, x[1], x[2], 0, 0, 0, 0});
      text += '\n';
    });
    text_ += "$EndNodeData\n";
  }

  const mesh& m_;
  const gmsh_contents& more_;
  gmsh_groups_by_number curves_, surfaces_;
  std::string text_;
};

}  // namespace

std::string gmsh_text(const mesh& m, const gmsh_contents& more, gmsh_version version) {
  gmsh_writer writer(m, more);
  return version == gmsh_version::two ? writer.two() : writer.four();
}

}  // namespace asterism::internal
