// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/read_mesh.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/other_kind.hpp"
#include "asterism/mesh/io/poly.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism {
using namespace internal;
namespace {

// Distinguishes gmsh's from FreeFEM's files: BAMG's meshes are named .msh, too.
bool begins_as_medit(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string first;
  constexpr std::streamsize longest = 64;
  first.resize(longest);
  in.read(first.data(), longest);
  first.resize(static_cast<std::size_t>(in.gcount()));
  return text_scanner("", first).next().text == "MeshVersionFormatted";
}

error no_metric(const file_kind& kind, const std::string& file) {
  const std::string where(kind.place_of_metric);
  return {file +
              (where.empty() ? ": files of this kind have no metric"
                             : ": there is no " + where + " \"metric\"") +
              "; give the metric as a formula",
          error_code::invalid_metric};
}

std::optional<error> check_metric(const file_kind& kind, const listed_mesh& m,
                                  const medit_read_options& options) {
  if (options.identity_without_solution || options.without_solution || m.has_metric) return {};
  return no_metric(kind, m.file);
}

bool is_of_medit(const file_kind& kind) { return kind.read == read_listed_medit; }

// Returns the kind by which the file is read: Medit's if the name has no known ending.
const file_kind& kind_to_read(const std::filesystem::path& path) {
  const file_kind& medit = *kind_of_file(".mesh");
  const file_kind* const kind = kind_of_file(path.string());
  if (kind == nullptr || kind->read == nullptr) return medit;
  std::error_code ignored;
  const bool may_be_medit = kind->ending == ".msh" || kind->ending == ".msh2";
  if (may_be_medit && std::filesystem::is_regular_file(path, ignored) && begins_as_medit(path))
    return medit;
  return *kind;
}

// Takes the metric of a file that has numbers for all vertices of the mesh's file, those left out
// included.
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
  const file_kind* const kind = kind_of_file(name);
  return kind != nullptr && kind->read != nullptr;
}

std::string kind_hint(const std::filesystem::path& path) {
  if (is_mesh_file(path.string())) return "";
  const std::string known = what_it_is(path.string());
  std::error_code ignored;
  if (!known.empty() || !std::filesystem::exists(path, ignored)) return known;
  return "; read as Medit's .mesh, as its name ends in none of " + endings_of(is_mesh_kind, "and");
}

result<mesh_file> read_mesh_file(const std::filesystem::path& path,
                                 const medit_read_options& options) {
  const file_kind& kind = kind_to_read(path);
  auto read = kind.read(path, options);
  if (!read) return error{read.failure().message + kind_hint(path), read.failure().code};
  listed_mesh& m = read.value();
  const bool has_own_metric = !is_of_medit(kind) && !m.content.triangles.empty();
  if (has_own_metric && !options.solution.empty())
    if (auto failed = take_metric(options.solution, m)) return *failed;
  if (has_own_metric)
    if (auto failed = check_metric(kind, m, options)) return *failed;
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
  if (!is_of_medit(kind_to_read(path))) return mesh_marks{};
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
  const file_kind* const kind = kind_of_file(path.string());
  if (kind == nullptr || kind->read == nullptr || is_of_medit(*kind)) return {};
  auto read = read_mesh_file(path, {.without_solution = true});
  return read ? std::move(read.value().names) : physical_names{};
}

}  // namespace asterism
