// SPDX-License-Identifier: MIT
//
// Makes a mesh within the limit on sites: refines the given vertices and the sites that the fill
// proposes.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"
#include "asterism/mesh/refine/site_budget.hpp"

namespace asterism::internal {

// Returns the reason why the options of a run do not fit this domain, if there is one.
std::optional<error> check_options(const domain& d, const mesh_options& options);

// Makes the mesh that make_mesh promises, on any kernel and in the metric given, in the
// unit frame; fills in everything of the outcome but the counters. Fails for options out of range,
// and where the field does. With a kernel that is not exact the outcome claims what that kernel
// believes.
result<mesh_outcome> mesh_domain(const meshing_context& job);

// Makes the mesh from sites proposed before, which must not be crowded.
result<mesh_outcome> mesh_from_sites(const meshing_context& job, budgeted_filling filled);

}  // namespace asterism::internal
