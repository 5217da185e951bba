// SPDX-License-Identifier: MIT
//
// Words what a mesh job was asked and what came of it, as certificates hold it.
#pragma once

#include <map>
#include <string>

#include "asterism/apps/job_input.hpp"
#include "asterism/apps/mesh_job.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::apps {

// Returns the options of the certificate, by name.
std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome);

}  // namespace asterism::apps
