// SPDX-License-Identifier: MIT
//
// Audits a mesh again, and compares its certificate with the results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/audit/region_areas.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Result of a second audit of a mesh and its certificate.
struct verify_report {
  bool verified = false;  // certified, and nothing contradicts the certificate
  audit_report audit;
  std::vector<std::string> contradictions;  // one sentence each, claim against mesh
  std::vector<region_area> regions;         // measured again
  // Hypotheses of the theorem on nets, measured again; of a certified mesh with an angle bound.
  std::optional<theorem_hypotheses> theorem;
  std::vector<periodic_match> periodic;  // found again, of the sides that the certificate names
};

// Audits again, from the mesh and the certificate alone. Takes the domain and the angle bound from
// the certificate where `options` has none of its own. Checks the certificate's claim on the
// Voronoi diagram. Searches for sharp corners. Without an angle bound from either nothing is
// certified, and `verified` is false.
ASTERISM_EXPORT verify_report verify(const mesh& subject, const std::optional<certificate>& claim,
                                     audit_options options);

}  // namespace asterism
