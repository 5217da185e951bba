// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/read_mesh.hpp"

#include <utility>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/gmsh.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_mesh.hpp"

namespace asterism {
using namespace internal;
namespace {

bool is_gmsh(std::string_view name) {
  return has_ending(name, ".msh") || has_ending(name, ".msh2");
}

bool is_vtu(std::string_view name) { return has_ending(name, ".vtu"); }

// Holds a mesh from a format whose files may contain the metric.
struct self_contained {
  mesh content;
  bool has_metric = false;
};

result<self_contained> read_self_contained(const std::filesystem::path& path) {
  if (is_gmsh(path.string())) {
    auto read = read_gmsh(path);
    if (!read) return read.failure();
    return self_contained{std::move(read.value().content), read.value().has_metric};
  }
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  auto read = read_vtu_mesh(text.value(), path.string());
  if (!read) return read.failure();
  return self_contained{std::move(read.value().content), read.value().has_metric};
}

}  // namespace

bool is_mesh_file(std::string_view name) {
  return has_ending(name, ".mesh") || has_ending(name, ".meshb") || is_gmsh(name) || is_vtu(name);
}

result<mesh> read_mesh(const std::filesystem::path& path, const medit_read_options& options) {
  if (!is_gmsh(path.string()) && !is_vtu(path.string())) return read_medit(path, options);
  const std::string where = is_vtu(path.string()) ? "point data" : "node data";
  if (!options.solution.empty())
    return error{options.solution.string() + ": the metric of " + path.string() + " is in it, as " +
                     where + " \"metric\"",
                 error_code::bad_option};
  auto read = read_self_contained(path);
  if (!read) return read.failure();
  if (!read.value().has_metric && !options.identity_without_solution && !options.without_solution)
    return error{
        path.string() + ": there is no " + where + " \"metric\"; give the metric as a formula",
        error_code::invalid_metric};
  return std::move(read.value().content);
}

result<mesh_marks> read_mesh_marks(const std::filesystem::path& path) {
  if (is_gmsh(path.string()) || is_vtu(path.string())) return mesh_marks{};
  return read_medit_marks(path);
}

physical_names names_in(const std::filesystem::path& path) {
  if (!is_gmsh(path.string())) return {};
  auto read = read_gmsh(path);
  return read ? std::move(read.value().names) : physical_names{};
}

}  // namespace asterism
