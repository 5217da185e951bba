// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/measured_claims.hpp"

#include <fmt/format.h>

#include <cmath>

#include "asterism/mesh/numerics/mesh_statistics.hpp"

namespace asterism::internal {

std::vector<std::string> contradictions_in_measured(const mesh& subject, const certificate& claim) {
  std::vector<std::string> all;
  if (claim.fingerprint != mesh_fingerprint(subject)) return all;
  const auto measured = by_name(measure(subject));
  for (const auto& [name, claimed] : claim.measured) {
    const auto found = measured.find(name);
    if (found == measured.end())
      all.push_back(fmt::format("\"measured.{}\" is nothing that is measured of a mesh", name));
    else if (found->second != claimed)
      all.push_back(fmt::format("\"measured.{}\" is {} in the certificate, and {} of this mesh",
                                name, claimed, found->second));
  }
  for (const auto& [name, value] : measured)
    if (std::isfinite(value) && claim.measured.count(name) == 0)
      all.push_back(fmt::format("\"measured.{}\" is missing", name));
  return all;
}

}  // namespace asterism::internal
