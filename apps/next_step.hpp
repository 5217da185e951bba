// SPDX-License-Identifier: MIT
//
// Says what to try after a run that did not end as wanted.
#pragma once

#include <string>

#include "asterism/apps/mesh_job.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {

// Returns a sentence that names options, for how the run ended; empty where none would help.
std::string next_step(const mesh_job& job, const certified_mesh& made);

}  // namespace asterism::apps
