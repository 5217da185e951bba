// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::internal {

// Does what adopt_mesh() does. Sets `found` to what an audit finds against what was adopted, but
// for its stars and angles, where that had to be asked: who wants to know need not ask again.
result<adopted_mesh> adopt_sharing(mesh from_elsewhere, std::optional<audit_report>& found);

}  // namespace asterism::internal
