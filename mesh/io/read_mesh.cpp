// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/read_mesh.hpp"

#include <utility>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/gmsh.hpp"

namespace asterism {
using namespace internal;
namespace {

bool is_gmsh(std::string_view name) {
  return has_ending(name, ".msh") || has_ending(name, ".msh2");
}

}  // namespace

bool is_mesh_file(std::string_view name) {
  return has_ending(name, ".mesh") || has_ending(name, ".meshb") || is_gmsh(name);
}

result<mesh> read_mesh(const std::filesystem::path& path, const medit_read_options& options) {
  if (!is_gmsh(path.string())) return read_medit(path, options);
  if (!options.solution.empty())
    return error{options.solution.string() + ": the metric of a .msh file is in it, as node data",
                 error_code::bad_option};
  auto read = read_gmsh(path);
  if (!read) return read.failure();
  if (!read.value().has_metric && !options.identity_without_solution && !options.without_solution)
    return error{path.string() + ": there is no node data \"metric\"; give the metric as a formula",
                 error_code::invalid_metric};
  return std::move(read.value().content);
}

physical_names names_in(const std::filesystem::path& path) {
  if (!is_gmsh(path.string())) return {};
  auto read = read_gmsh(path);
  return read ? std::move(read.value().names) : physical_names{};
}

}  // namespace asterism
