// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/read_mesh.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/poly.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_mesh.hpp"

namespace asterism {
using namespace internal;
namespace {

using text_reader = result<listed_mesh> (*)(std::string_view, const std::string&);

// Formats whose one file holds the mesh, and the metric where they have a place for it.
struct whole_file_format {
  std::string_view ending, place_of_metric;
  text_reader read;  // null: by read_gmsh
};
constexpr std::array<whole_file_format, 9> readers_of_whole_files = {
    {{".msh", "node data", nullptr},
     {".msh2", "node data", nullptr},
     {".vtu", "point data", read_vtu_mesh},
     {".vtk", "", read_vtk},
     {".su2", "", read_su2},
     {".14", "", read_adcirc},
     {".grd", "", read_adcirc},
     {".2dm", "", read_sms},
     {".stl", "", read_stl}}};

// BAMG's meshes are named .msh, too.
bool begins_as_medit(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string first;
  constexpr std::streamsize longest = 64;
  first.resize(longest);
  in.read(first.data(), longest);
  first.resize(static_cast<std::size_t>(in.gcount()));
  return text_scanner("", first).next().text == "MeshVersionFormatted";
}

const whole_file_format* format_of(std::string_view name) {
  const auto at =
      std::find_if(readers_of_whole_files.begin(), readers_of_whole_files.end(),
                   [name](const whole_file_format& f) { return has_ending(name, f.ending); });
  return at == readers_of_whole_files.end() ? nullptr : &*at;
}

result<listed_mesh> read_whole(const whole_file_format& format, const std::filesystem::path& path) {
  if (format.read == nullptr) return read_gmsh(path);
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  return format.read(text.value(), path.string());
}

error no_metric(const whole_file_format& format, const std::string& file) {
  const std::string where(format.place_of_metric);
  return {file +
              (where.empty() ? ": files of this kind have no metric"
                             : ": there is no " + where + " \"metric\"") +
              "; give the metric as a formula",
          error_code::invalid_metric};
}

std::optional<error> check_metric(const whole_file_format& format, const listed_mesh& m,
                                  const medit_read_options& options) {
  if (options.identity_without_solution || options.without_solution || m.has_metric) return {};
  return no_metric(format, m.file);
}

const whole_file_format* format_of_file(const std::filesystem::path& path) {
  const whole_file_format* const format = format_of(path.string());
  const bool may_be_medit = format != nullptr && format->read == nullptr;
  std::error_code ignored;
  if (may_be_medit && std::filesystem::is_regular_file(path, ignored) && begins_as_medit(path))
    return nullptr;
  return format;
}

// Takes the metric of a file with numbers for all vertices of the mesh's, those left out, too.
std::optional<error> take_metric(const std::filesystem::path& file, listed_mesh& m) {
  mesh whole;
  whole.sites.resize(m.content.sites.size() + m.left_out.size());
  medit_read_options named;
  named.solution = file;
  const auto read = read_medit_solution(file, whole, named);
  if (!read) return read.failure();
  auto next = m.left_out.begin();
  std::size_t kept = 0;
  for (std::size_t v = 0; v < whole.sites.size(); ++v) {
    if (next != m.left_out.end() && *next == v)
      ++next;
    else
      m.content.sites[kept++].metric = whole.sites[v].metric;
  }
  m.has_metric = true;
  return std::nullopt;
}

}  // namespace

bool is_metric_file(std::string_view name) {
  return has_ending(name, ".sol") || has_ending(name, ".solb") || has_ending(name, ".mtr");
}

bool is_mesh_file(std::string_view name) {
  return has_ending(name, ".mesh") || has_ending(name, ".meshb") || format_of(name) != nullptr;
}

result<mesh_file> read_mesh_file(const std::filesystem::path& path,
                                 const medit_read_options& options) {
  const whole_file_format* const format = format_of_file(path);
  auto read = format == nullptr ? read_listed_medit(path, options) : read_whole(*format, path);
  if (!read && !is_mesh_file(path.string()))
    return error{read.failure().message +
                     "; read as Medit's .mesh, as its name ends in none of .mesh, .meshb, .msh, "
                     ".msh2, .vtu, .vtk, .su2, .14, .grd, .2dm and .stl",
                 read.failure().code};
  if (!read) return read.failure();
  listed_mesh& m = read.value();
  const bool is_mesh = !m.content.triangles.empty();
  if (format != nullptr && is_mesh && !options.solution.empty())
    if (auto failed = take_metric(options.solution, m)) return *failed;
  if (format != nullptr && is_mesh)
    if (auto failed = check_metric(*format, m, options)) return *failed;
  return mesh_file{std::move(m.content),  std::move(m.marks), std::move(m.names),
                   std::move(m.left_out), m.has_metric,       std::move(m.parts),
                   m.second_order,        std::move(m.curved)};
}

result<mesh> read_mesh(const std::filesystem::path& path, const medit_read_options& options) {
  auto read = read_mesh_file(path, options);
  if (!read) return read.failure();
  return std::move(read.value().content);
}

result<mesh_marks> read_mesh_marks(const std::filesystem::path& path) {
  if (format_of_file(path) != nullptr) return mesh_marks{};
  auto read = read_mesh_file(path, {.without_solution = true});
  if (!read) return read.failure();
  return std::move(read.value().marks);
}

void take_back_note_of_corners(mesh_file& read) {
  auto& notes = read.content.notes;
  notes.erase(std::remove(notes.begin(), notes.end(), note_of_higher_order(read.second_order)),
              notes.end());
}

physical_names names_in(const std::filesystem::path& path) {
  if (has_ending(path.string(), ".poly")) return {{}, region_names_in_poly(path)};
  if (format_of(path.string()) == nullptr) return {};
  auto read = read_mesh_file(path, {.without_solution = true});
  return read ? std::move(read.value().names) : physical_names{};
}

}  // namespace asterism
