// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/read_triangulation.hpp"

#include <utility>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

namespace asterism::internal {

result<adopted_mesh> checked_triangulation(mesh read, const std::string& path) {
  auto adopted = adopt_mesh(std::move(read));
  if (!adopted) return error{path + ": " + adopted.failure().message};
  audit_options options;
  options.check_stars = false;
  const audit_report found = audit(adopted.value().subject, options);
  if (!found.certified)
    return error{path + " is no triangulation: " + found.findings.at(0).witness};
  return adopted;
}

result<mesh_file> read_plain_mesh_file(const std::string& path) {
  medit_read_options how;
  how.without_solution = true;
  auto read = read_mesh_file(path, how);
  if (!read) return read;
  auto checked = checked_triangulation(read.value().content, path);
  if (!checked) return checked.failure();
  read.value().content.notes = std::move(checked.value().subject.notes);
  return read;
}

result<mesh> read_plain_triangulation(const std::string& path) {
  auto read = read_plain_mesh_file(path);
  if (!read) return read.failure();
  return std::move(read.value().content);
}

result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted) {
  medit_read_options how;
  how.identity_without_solution = !metric_wanted;
  auto read = read_mesh(path, how);
  if (!read) return read.failure();
  return checked_triangulation(std::move(read).value(), path);
}

}  // namespace asterism::internal
