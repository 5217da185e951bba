// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/render_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/file_note.hpp"
#include "asterism/mesh/io/flow_meshes.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_writer.hpp"
#include "asterism/mesh/io/mesh_format.hpp"
#include "asterism/mesh/io/plain_meshes.hpp"
#include "asterism/mesh/io/side_node_mesh.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/io/vtu.hpp"

namespace asterism::internal {
namespace fs = std::filesystem;

namespace {

picture_format picture_format_of(mesh_format format) {
  if (format == mesh_format::svg) return picture_format::svg;
  return format == mesh_format::png ? picture_format::png : picture_format::pdf;
}

// Checks the indices of a mesh made by hand: writers use them unchecked.
std::optional<error> check_indices(const mesh& m) {
  const auto bad = [&](vertex_index v) { return v >= m.sites.size(); };
  for (const auto* triangles : {&m.triangles, &m.disagreeing})
    for (const triangle& t : *triangles)
      if (std::any_of(t.begin(), t.end(), bad))
        return error{"a triangle names a missing site", error_code::invalid_mesh};
  for (const boundary_edge& e : m.boundary)
    if (bad(e.a) || bad(e.b))
      return error{"a boundary edge names a missing site", error_code::invalid_mesh};
  if (!m.regions.empty() && m.regions.size() != m.triangles.size())
    return error{"there are not as many regions as triangles", error_code::invalid_mesh};
  if (m.given > m.sites.size())
    return error{"more given vertices than sites", error_code::invalid_mesh};
  return {};
}

// Gives the pieces of `write`, with the note in the first one.
std::function<void(const byte_sink&)> with_note(std::function<void(const byte_sink&)> write,
                                                mesh_format format, const std::string& note) {
  return [write = std::move(write), format, note](const byte_sink& put) {
    bool is_first = true;
    write([&](std::string_view piece) {
      if (!std::exchange(is_first, false)) return put(piece);
      put(with_file_note(std::string(piece), format, note));
    });
  };
}

using output_files = std::vector<output_file>;

result<output_files> render_picture(const fs::path& path, mesh_format format, const mesh& m,
                                    const write_options& options) {
  auto picture = draw_picture(m, picture_format_of(format), options.picture);
  if (!picture.ok()) return picture.failure().at(path.string());
  if (format != mesh_format::svg) return output_files{{path, std::move(picture).value()}};
  return output_files{{path, with_file_note(std::move(picture).value(), format, options.note)}};
}

result<output_files> render_page(const fs::path& path, const mesh& m,
                                 const write_options& options) {
  auto page = report_page(m, options.report);
  if (!page.ok()) return page.failure().at(path.string());
  return output_files{{path, std::move(page).value()}};
}

// Returns the note as a line of its own; empty if there is no note.
std::string comment(const std::string& mark, std::string note) {
  std::replace_if(
      note.begin(), note.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return note.empty() ? "" : mark + note + "\n";
}

// Writes the note after the first section, which must come first.
std::string render_gmsh(const mesh& m, const write_options& options, gmsh_version version,
                        const side_node_mesh* nodes) {
  std::string text =
      gmsh_text(m, {options.names, options.with_metric, options.fields, nodes}, version);
  if (options.note.empty()) return text;
  const std::string_view first = "$EndMeshFormat\n";
  return text.insert(text.find(first) + first.size(),
                     "$Comments\n" + comment("", options.note) + "$EndComments\n");
}

// Returns the numbers, from 1, of the edges with triangles on both sides.
std::vector<std::size_t> inner_edges(const mesh& m) {
  std::vector<std::size_t> inner;
  for (std::size_t e = 0; e < m.boundary.size(); ++e)
    if (m.boundary[e].internal) inner.push_back(e + 1);
  return inner;
}

// Returns the files of a Medit mesh: its own, and one each for the metric and the fields.
output_files with_solutions(output_file first, const mesh& m, const write_options& options) {
  const fs::path path = first.path, beside = solution_path(path);
  output_files files = {std::move(first)};
  if (options.with_metric && is_medit_binary(path))
    files.push_back({beside, medit_binary_of_text(medit_solution_text(m))});
  else if (options.with_metric)
    files.push_back(
        {.path = beside, .rest = [&m](const byte_sink& put) { write_medit_solution(m, put); }});
  if (options.fields != nullptr && !options.fields->fields.empty())
    files.push_back(
        {options.with_metric ? fields_path(path) : beside, solution_text(beside, *options.fields)});
  return files;
}

result<output_files> render_vtu(const fs::path& path, const mesh& m, const write_options& options) {
  const vtu_contents values{options.with_metric, options.fields};
  const auto vtu = [&m, values](const byte_sink& put) { write_vtu(m, values, put); };
  return output_files{{.path = path, .rest = with_note(vtu, mesh_format::vtu, options.note)}};
}

// Writes the triangles with the nodes of their sides, and the values at these as well.
result<output_files> render_second_order(const fs::path& path, mesh_format format, const mesh& m,
                                         const write_options& options) {
  const auto nodes =
      std::make_shared<side_node_mesh>(with_side_nodes(m, options.curved, options.fields));
  write_options how = options;
  how.fields = options.fields == nullptr ? nullptr : &nodes->fields;
  if (format != mesh_format::vtu) {
    const auto version = format == mesh_format::gmsh ? gmsh_version::four : gmsh_version::two;
    return output_files{{path, render_gmsh(nodes->content, how, version, nodes.get())}};
  }
  const vtu_contents values{how.with_metric, how.fields, nodes.get()};
  const auto vtu = [nodes, values](const byte_sink& put) {
    write_vtu(nodes->content, values, put);
  };
  return output_files{{.path = path, .rest = with_note(vtu, format, options.note)}};
}

result<output_files> render(const fs::path& path, mesh_format format, const mesh& m,
                            const write_options& options) {
  if (options.order == 2 && holds_second_order(format))
    return render_second_order(path, format, m, options);
  const bool keeps_comments = format == mesh_format::medit;
  const auto medit = [&m, smooth = medit_smooth{options.smooth, keeps_comments}](
                         const byte_sink& put) { write_medit_mesh(m, smooth, put); };
  switch (format) {
    case mesh_format::medit:
      return with_solutions({.path = path, .rest = with_note(medit, format, options.note)}, m,
                            options);
    case mesh_format::medit_binary:
      return with_solutions({path, medit_binary_of_text(bytes_of(medit), inner_edges(m))}, m,
                            options);
    case mesh_format::vtu:
      return render_vtu(path, m, options);
    case mesh_format::gmsh:
      return output_files{{path, render_gmsh(m, options, gmsh_version::four, nullptr)}};
    case mesh_format::gmsh2:
      return output_files{{path, render_gmsh(m, options, gmsh_version::two, nullptr)}};
    case mesh_format::su2:
      return output_files{{path, comment("% ", options.note) + su2_text(m, options.names)}};
    case mesh_format::sms:
      return output_files{{path, sms_text(m)}};
    case mesh_format::adcirc:
      return output_files{{path, adcirc_text(m, options.names, comment("", options.note))}};
    case mesh_format::node:
      return output_files{{path, comment("# ", options.note) + node_text(m)},
                          {fs::path(path).replace_extension(".ele"), ele_text(m)},
                          {fs::path(path).replace_extension(".edge"), edge_text(m)}};
    case mesh_format::html:
      return render_page(path, m, options);
    case mesh_format::svg:
    case mesh_format::png:
    case mesh_format::pdf:
      return render_picture(path, format, m, options);
  }
  return error{path.string() + ": there is no such format", error_code::bad_option};
}

// Returns the nodes of sides in the numbers of a parted mesh: of the boundary's edges.
std::vector<side_node> nodes_in(const parted_mesh& parted, const std::vector<side_node>& nodes) {
  std::map<std::pair<vertex_index, vertex_index>, point> at;
  for (const side_node& s : nodes) at[{s.a, s.b}] = s.at;
  std::map<std::pair<vertex_index, vertex_index>, point> made;
  for (const boundary_edge& e : parted.content.boundary) {
    const auto found = at.find(std::minmax(parted.original[e.a], parted.original[e.b]));
    if (found != at.end()) made[std::minmax(e.a, e.b)] = found->second;
  }
  std::vector<side_node> all;
  for (const auto& [ends, place] : made) all.push_back({ends.first, ends.second, place});
  return all;
}

solution fields_in(const parted_mesh& parted, const solution& fields) {
  solution made = fields;
  for (std::size_t v = fields.vertices; v < parted.original.size(); ++v)
    for (solution_field& field : made.fields) {
      const std::size_t c = components_of(field.kind);
      for (std::size_t i = 0; i < c; ++i)
        field.values.push_back(field.values[parted.original[v] * c + i]);
    }
  made.vertices = parted.original.size();
  return made;
}

// Writes the mesh with the vertices of both sides of its cracks. The mesh lives as long as its
// files are rendered.
result<output_files> render_parted(const fs::path& path, mesh_format format, const mesh& m,
                                   const write_options& options) {
  struct parted {
    parted_mesh made;
    solution fields;
  };
  const auto held = std::make_shared<parted>(parted{part_cracks(m, options.cracks), {}});
  write_options how = options;
  how.curved = nodes_in(held->made, options.curved);
  if (options.fields != nullptr) {
    held->fields = fields_in(held->made, *options.fields);
    how.fields = &held->fields;
  }
  auto files = render(path, format, held->made.content, how);
  if (!files) return files;
  for (output_file& file : files.value())
    if (file.rest)
      file.rest = [held, rest = std::move(file.rest)](const byte_sink& put) { rest(put); };
  return files;
}

}  // namespace

fs::path fields_path(const fs::path& mesh_path) {
  return fs::path(mesh_path).replace_extension(is_medit_binary(mesh_path) ? ".fields.solb"
                                                                          : ".fields.sol");
}

result<mesh_format> check_place_of_output(const std::filesystem::path& path) {
  auto format = mesh_format_of(path);
  std::error_code ignored;
  if (!format.ok() && fs::is_directory(path, ignored))
    return error{path.string() + ": is a directory; a file in it is wanted, as " +
                     (path / "NAME.mesh").string(),
                 error_code::bad_option};
  if (!format.ok()) return format;
  if (is_picture(format.value()))
    if (const auto missing = missing_for_pictures()) return missing->at(path.string());
  for (const fs::path& file : files_of_output(path))
    if (const auto failed = check_place(place_of(file))) return *failed;
  return format;
}

result<std::vector<output_file>> render_mesh(const std::filesystem::path& path, const mesh& m,
                                             const write_options& options) {
  const auto format = check_place_of_output(path);
  if (!format.ok()) return format.failure();
  if (auto failed = check_indices(m)) return failed->at(path.string());
  // Renders pictures and pages of the mesh with one vertex at each place, to which their facts
  // refer.
  if (options.cracks.empty() || is_drawing(format.value()))
    return render(path, format.value(), m, options);
  return render_parted(path, format.value(), m, options);
}

}  // namespace asterism::internal
