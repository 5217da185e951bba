// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/write_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/vtu.hpp"

namespace asterism {
using namespace internal;

namespace {

constexpr std::array<std::pair<std::string_view, mesh_format>, 5> formats = {
    {{".mesh", mesh_format::medit},
     {".vtu", mesh_format::vtu},
     {".svg", mesh_format::svg},
     {".png", mesh_format::png},
     {".pdf", mesh_format::pdf}}};

std::string lower(std::string text) {
  for (char& c : text) c = lower_case(c);
  return text;
}

picture_format picture_format_of(mesh_format format) {
  if (format == mesh_format::svg) return picture_format::svg;
  return format == mesh_format::png ? picture_format::png : picture_format::pdf;
}

// Writers index by these; a mesh made by hand may be wrong.
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

// `contents` with the note as a comment after its first line, which all three text formats want to
// be theirs. In XML a comment must not hold two hyphens in a row.
std::string with_note(std::string contents, mesh_format format, const std::string& note) {
  if (note.empty()) return contents;
  std::string line;
  for (const char c : note) {
    if (c == '-' && !line.empty() && line.back() == '-') line += ' ';
    line += c == '\n' || c == '\r' ? ' ' : c;
  }
  line = format == mesh_format::medit ? "# " + line + "\n" : "<!-- " + line + " -->\n";
  return contents.insert(contents.find('\n') + 1, line);
}

result<std::vector<output_file>> render(const std::filesystem::path& path, mesh_format format,
                                        const mesh& m, const write_options& options) {
  if (format == mesh_format::medit)
    return std::vector<output_file>{{path, with_note(medit_mesh_text(m), format, options.note)},
                                    {solution_path(path), medit_solution_text(m)}};
  if (format == mesh_format::vtu)
    return std::vector<output_file>{{path, with_note(vtu_text(m), format, options.note)}};
  auto picture = draw_picture(m, picture_format_of(format), options.picture);
  if (!picture.ok()) return picture.failure().at(path.string());
  if (format == mesh_format::svg)
    return std::vector<output_file>{
        {path, with_note(std::move(picture).value(), format, options.note)}};
  return std::vector<output_file>{{path, std::move(picture).value()}};
}

}  // namespace

result<mesh_format> mesh_format_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  for (const auto& [name, format] : formats)
    if (extension == name) return format;
  return error{path.string() + ": unknown kind of file '" + extension +
                   "'; there are .mesh, .vtu, .svg, .png and .pdf",
               error_code::bad_option};
}

result<mesh_format> check_output(const std::filesystem::path& path) {
  auto format = mesh_format_of(path);
  if (!format.ok()) return format;
  if (const auto writable = check_writable(path); !writable.ok()) return writable.failure();
  if (format.value() == mesh_format::medit)
    if (const auto writable = check_writable(solution_path(path)); !writable.ok())
      return writable.failure();
  return format;
}

namespace internal {

result<std::vector<output_file>> render_mesh(const std::filesystem::path& path, const mesh& m,
                                             const write_options& options) {
  const auto format = check_output(path);
  if (!format.ok()) return format.failure();
  if (auto failed = check_indices(m)) return failed->at(path.string());
  return render(path, format.value(), m, options);
}

}  // namespace internal

result<std::vector<std::filesystem::path>> write_mesh(const std::filesystem::path& path,
                                                      const mesh& m, const write_options& options) {
  const auto files = render_mesh(path, m, options);
  if (!files.ok()) return files.failure();
  return write_files(files.value());
}

}  // namespace asterism
