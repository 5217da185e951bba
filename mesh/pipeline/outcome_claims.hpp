// SPDX-License-Identifier: MIT
//
// Checks what a certificate says of how its run ended against the rest of the certificate.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"

namespace asterism::internal {

// The reason in the certificate of a mesh that `certify` did not change.
inline constexpr std::string_view certified_as_it_came = "the mesh as it came is certified";

// Returns a sentence if the certificate says that the run was completed, and its reason is none
// that a completed run with this metric delivered gives. None where no metric is named: whoever
// calls the library words the reason.
std::vector<std::string> contradictions_in_outcome(const certificate& claim);

}  // namespace asterism::internal
