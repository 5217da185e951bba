// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism {
using namespace internal;

namespace {

using text = std::back_insert_iterator<std::string>;

bool is_among(const std::vector<vertex_index>& sorted, vertex_index v) {
  return std::binary_search(sorted.begin(), sorted.end(), v);
}

// Returns the given vertices at which the boundary is not one straight line, and not smooth.
std::vector<vertex_index> corners(const mesh& m, const std::vector<vertex_index>& smooth) {
  struct ends {
    vertex_index from = 0, to = 0;  // the last ones seen
    std::size_t arriving = 0, leaving = 0;
  };
  std::map<vertex_index, ends> at;
  for (const boundary_edge& e : m.boundary) {
    if (e.a >= m.sites.size() || e.b >= m.sites.size()) continue;
    if (e.a < m.given) {
      at[e.a].to = e.b;
      ++at[e.a].leaving;
    }
    if (e.b < m.given) {
      at[e.b].from = e.a;
      ++at[e.b].arriving;
    }
  }
  const filtered_kernel kernel;
  std::vector<vertex_index> found;
  for (const auto& [v, beside] : at) {
    const bool simple = beside.leaving == 1 && beside.arriving == 1;
    if (simple && kernel.orientation(m.sites[beside.from].position, m.sites[v].position,
                                     m.sites[beside.to].position) == sign::zero)
      continue;
    if (!is_among(smooth, v)) found.push_back(v);
  }
  return found;
}

void write_list(std::string& to, const char* keyword, const std::vector<vertex_index>& numbers) {
  if (numbers.empty()) return;
  fmt::format_to(text(to), "\n{}\n{}\n", keyword, numbers.size());
  for (const vertex_index v : numbers) {
    append_integer(to, v + 1);
    to += '\n';
  }
}

// Splits comments at 80 characters: some readers take lines in subsegments of a fixed length.
void write_segments(text out, const mesh& m) {
  std::string line = "#segments";
  for (const boundary_edge& e : m.boundary) {
    const std::string number = fmt::format(" {}", std::size_t{e.segment} + 1);
    if (line.size() + number.size() > 80) {
      fmt::format_to(out, "{}\n", line);
      line = "#segments";
    }
    line += number;
  }
  fmt::format_to(out, "{}\n", line);
}

void write_boundary(text out, const mesh& m) {
  if (m.boundary.empty()) return;
  fmt::format_to(out, "\nEdges\n{}\n", m.boundary.size());
  for (const boundary_edge& e : m.boundary)
    fmt::format_to(out, "{} {} {}\n", e.a + 1, e.b + 1, e.marker);
  write_segments(out, m);
}

}  // namespace

namespace internal {

void write_medit_mesh(const mesh& m, const medit_smooth& smooth, const byte_sink& put) {
  put(fmt::format("MeshVersionFormatted 2\n\nDimension 2\n\nVertices\n{}\n", m.sites.size()));
  const bool has_own = m.references.size() == m.sites.size();
  const std::vector<int> references = has_own ? m.references : vertex_references(m);
  make_lines(
      m.sites.size(),
      [&](std::size_t v, std::string& line) {
        append_number(line, m.sites[v].position.x);
        append_number(line += ' ', m.sites[v].position.y);
        append_integer(line += ' ', references[v]);
        line += '\n';
      },
      put);
  put(fmt::format("\nTriangles\n{}\n", m.triangles.size()));
  make_lines(
      m.triangles.size(),
      [&](std::size_t i, std::string& line) {
        for (const vertex_index v : m.triangles[i]) {
          append_integer(line, v + 1);
          line += ' ';
        }
        append_integer(line, region_of(m, i));
        line += '\n';
      },
      put);
  std::string end;
  const text out(end);
  write_boundary(out, m);
  write_list(end, "Corners", corners(m, smooth.vertices));
  const bool may_go = smooth.keeps_comments && !smooth.vertices.empty();
  std::vector<vertex_index> required;
  for (vertex_index v = 0; v < m.given; ++v)
    if (!may_go || !is_among(smooth.vertices, v)) required.push_back(v);
  write_list(end, "RequiredVertices", required);
  if (may_go) fmt::format_to(out, "#given {}\n", m.given);
  put(end += "\nEnd\n");
}

void write_medit_solution(const mesh& m, const byte_sink& put) {
  // Writes one field, of type 3: a symmetric tensor, its upper triangle column by column.
  put(fmt::format("MeshVersionFormatted 2\n\nDimension 2\n\nSolAtVertices\n{}\n1 3\n",
                  m.sites.size()));
  make_lines(
      m.sites.size(),
      [&](std::size_t v, std::string& line) {
        const metric_tensor& metric = m.sites[v].metric;
        append_number(line, metric.m11);
        append_number(line += ' ', metric.m12);
        append_number(line += ' ', metric.m22);
        line += '\n';
      },
      put);
  put("\nEnd\n");
}

}  // namespace internal

std::string medit_mesh_text(const mesh& m) {
  return bytes_of([&m](const byte_sink& put) { write_medit_mesh(m, {}, put); });
}

std::string medit_solution_text(const mesh& m) {
  return bytes_of([&m](const byte_sink& put) { write_medit_solution(m, put); });
}

std::filesystem::path solution_path(const std::filesystem::path& mesh_path) {
  return std::filesystem::path(mesh_path).replace_extension(is_medit_binary(mesh_path) ? ".solb"
                                                                                       : ".sol");
}

}  // namespace asterism
