// SPDX-License-Identifier: MIT
//
// Suggests what to try after a run that did not reach its goal.
#pragma once

#include <string>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {

// Returns options to add or to replace, those likeliest to help first and with their numbers, then
// other ways; empty where none would help. The suggestion depends on what prevented the goal, not
// on how the run ended. The table of docs/manual/statuses.md has a run for each.
std::string next_step(const mesh_job& job, const prepared_input& input, const certified_mesh& made);

}  // namespace asterism::apps
