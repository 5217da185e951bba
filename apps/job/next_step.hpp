// SPDX-License-Identifier: MIT
//
// Says what to try after a run that did not end as wanted.
#pragma once

#include <string>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {

// Returns options to add or to replace, those likeliest to help first and with their numbers, then
// other ways; empty where none would help. Goes by what kept the run from its end, not by how it
// ended. The table of docs/manual/statuses.md has a run for each.
std::string next_step(const mesh_job& job, const prepared_input& input, const certified_mesh& made);

}  // namespace asterism::apps
