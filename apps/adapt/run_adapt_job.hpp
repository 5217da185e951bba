// SPDX-License-Identifier: MIT
//
// Runs the command `adapt`, step by step: metric, domain, mesh, transfer, files.
#pragma once

#include "asterism/apps/adapt/adapt_job.hpp"

namespace asterism::apps {

// Returns the exit status. Messages go to standard error, the summary to standard output.
int run_adapt_job(adapt_job job);

}  // namespace asterism::apps
