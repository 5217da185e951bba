// SPDX-License-Identifier: MIT
//
// Compares a certificate's statement of how its run ended with the rest of the certificate.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"

namespace asterism::internal {

// The reason in the certificate of a mesh that `certify` did not change.
inline constexpr std::string_view certified_as_it_came = "the mesh as it came is certified";

// Returns a sentence if the certificate states that the run was completed, with a reason that no
// completed run with this delivered metric gives. Returns none where no metric is named: callers of
// the library write the reason themselves.
std::vector<std::string> contradictions_in_outcome(const certificate& claim);

}  // namespace asterism::internal
