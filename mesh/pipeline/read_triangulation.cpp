// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/read_triangulation.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"

namespace asterism::internal {

result<adopted_mesh> checked_triangulation(mesh read, const std::string& path, slit_rule slits) {
  auto adopted = adopt_mesh(std::move(read), region_edges::segments, slits);
  if (!adopted) return error{path + ": " + adopted.failure().message};
  const audit_report found = auditor(adopted.value().subject, {}).check_triangulation();
  if (!found.certified)
    return error{path + " is no triangulation: " + found.findings.at(0).witness};
  return adopted;
}

result<mesh_file> read_plain_mesh_file(const std::string& path) {
  medit_read_options how;
  how.without_solution = true;
  auto read = read_mesh_file(path, how);
  if (!read) return read;
  auto checked = checked_triangulation(read.value().content, path, slit_rule::joined);
  if (!checked) return checked.failure();
  read.value().content.notes = std::move(checked.value().subject.notes);
  return read;
}

result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted) {
  medit_read_options how;
  how.identity_without_solution = !metric_wanted;
  auto read = read_mesh(path, how);
  if (!read) return read.failure();
  return checked_triangulation(std::move(read).value(), path, slit_rule::joined);
}

namespace {

// Returns the file of the mesh to whose vertices a file of numbers belongs; empty where there is
// none.
std::string mesh_of_numbers(const std::string& name, const std::string& mesh) {
  if (is_mesh_file(mesh)) return mesh;
  std::error_code ignored;
  for (const char* const ending : {".mesh", ".meshb", ".msh", ".vtu"}) {
    const auto beside = std::filesystem::path(name).replace_extension(ending);
    if (std::filesystem::exists(beside, ignored)) return beside.string();
  }
  return "";
}

}  // namespace

bool is_metric_on_mesh(std::string_view name) { return is_mesh_file(name) || is_metric_file(name); }

result<adopted_mesh> read_metric_on_mesh(const std::string& name, const std::string& mesh) {
  if (is_mesh_file(name)) return read_triangulation(name, true);
  const std::string of = mesh_of_numbers(name, mesh);
  if (of.empty())
    return error{
        name +
            ": numbers at the vertices of a mesh, which is missing: the domain is no mesh, "
            "and no file .mesh, .meshb, .msh or .vtu of this name is beside it",
        error_code::bad_option};
  medit_read_options how;
  how.solution = name;
  auto read = read_mesh(of, how);
  if (!read) return read.failure();
  return checked_triangulation(std::move(read).value(), of, slit_rule::joined);
}

result<std::vector<metric_tensor>> read_metric_at_vertices(const std::string& mesh_file,
                                                           const std::string& metric) {
  medit_read_options how;
  if (is_mesh_file(metric))
    how.without_solution = true;
  else
    how.solution = metric;
  const auto read = read_mesh(mesh_file, how);
  if (!read) return read.failure();
  std::vector<metric_tensor> found;
  if (!is_mesh_file(metric)) {
    for (const site& s : read.value().sites) found.push_back(s.metric);
    return found;
  }
  const auto background = read_triangulation(metric, true);
  if (!background) return background.failure();
  const auto field = make_interpolated_field(background.value().subject);
  for (const site& s : read.value().sites) {
    const auto there = field->at(s.position);
    if (!there) return there.failure().at(metric);
    found.push_back(there.value());
  }
  return found;
}

}  // namespace asterism::internal
