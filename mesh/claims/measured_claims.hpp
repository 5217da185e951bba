// SPDX-License-Identifier: MIT
//
// Compares the measurements in a certificate with those of numerics/mesh_statistics.hpp. The
// auditor does not check them, as it shares no code with the mesher.
#pragma once

#include <string>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns a sentence for each number that differs to the last bit, is missing, or has a
// name that is not measured; none where the certificate is of another mesh, by its
// fingerprint.
std::vector<std::string> contradictions_in_measured(const mesh& subject, const certificate& claim);

}  // namespace asterism::internal
