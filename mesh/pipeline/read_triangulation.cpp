// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/read_triangulation.hpp"

#include <optional>
#include <utility>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/adopt_sharing.hpp"

namespace asterism::internal {

result<adopted_mesh> checked_triangulation(mesh read, const std::string& path) {
  std::optional<audit_report> found;
  auto adopted = adopt_sharing(std::move(read), found);
  if (!adopted) return error{path + ": " + adopted.failure().message};
  if (!found) {
    audit_options options;
    options.check_stars = false;
    found = audit(adopted.value().subject, options);
  }
  if (!found->certified)
    return error{path + " is no triangulation: " + found->findings.at(0).witness};
  return adopted;
}

result<mesh> read_plain_triangulation(const std::string& path) {
  medit_read_options how;
  how.without_solution = true;
  auto read = read_medit(path, how);
  if (!read) return read;
  const auto checked = checked_triangulation(read.value(), path);
  if (!checked) return checked.failure();
  return read;
}

result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted) {
  medit_read_options how;
  how.identity_without_solution = !metric_wanted;
  auto read = read_mesh(path, how);
  if (!read) return read.failure();
  return checked_triangulation(std::move(read).value(), path);
}

}  // namespace asterism::internal
