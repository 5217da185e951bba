// SPDX-License-Identifier: MIT
//
// Holds the numbers a certificate has measured of a mesh against what numerics/mesh_statistics.hpp
// measures. This is not the auditor's part, which shares no code with what made the mesh.
#pragma once

#include <string>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns a sentence for each number that is another one, to the last bit, is missing, or is of
// something that is not measured; none where the certificate is of another mesh, by its
// fingerprint.
std::vector<std::string> contradictions_in_measured(const mesh& subject, const certificate& claim);

}  // namespace asterism::internal
