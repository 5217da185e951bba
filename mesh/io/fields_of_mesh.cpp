// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/fields_of_mesh.hpp"

#include <system_error>
#include <utility>
#include <vector>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/solution_output.hpp"

namespace asterism::internal {
namespace {

namespace fs = std::filesystem;

// Returns the file with the fields of a Medit mesh; empty where there is none.
fs::path fields_beside(const fs::path& path) {
  std::error_code ignored;
  const auto text_or_binary = [&ignored](fs::path file) {
    if (fs::exists(file, ignored)) return file;
    file.replace_extension(file.extension() == ".solb" ? ".sol" : ".solb");
    return fs::exists(file, ignored) ? file : fs::path();
  };
  fs::path beside = text_or_binary(solution_path(path));
  if (!beside.empty() && !holds_tensors(beside)) return beside;
  return text_or_binary(fields_path(path));
}

// True for the metric's second copy in a .vtu that was written here: nine entries at each vertex,
// for programs that draw tensors. It is no field, and would be written twice.
bool is_metric_again(const solution_field& f) {
  return f.kind == field_kind::tensor && f.name == "metric_tensor";
}

}  // namespace

result<solution> fields_of_mesh(const fs::path& path, const mesh_file& read) {
  const std::string name = path.string();
  const bool is_medit = has_ending(name, ".mesh") || has_ending(name, ".meshb");
  fs::path file;
  if (is_medit) file = fields_beside(path);
  if (holds_fields(name)) file = path;
  solution none;
  none.vertices = read.content.sites.size();
  if (file.empty()) return none;
  auto found = read_fields(file, read.content, read.left_out);
  if (found && read.has_metric) std::erase_if(found.value().fields, is_metric_again);
  return found;
}

}  // namespace asterism::internal
