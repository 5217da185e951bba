// SPDX-License-Identifier: MIT
//
// Runs the main job, step by step: domain, metric, mesh, audit, files.
#pragma once

#include "asterism/apps/base/mesh_job.hpp"

namespace asterism::apps {

// Returns the exit status. Input is refused before meshing where that is possible; messages go to
// standard error, the summary to standard output.
int run_mesh_job(const mesh_job& job);

}  // namespace asterism::apps
