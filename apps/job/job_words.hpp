// SPDX-License-Identifier: MIT
//
// Words what a mesh job was asked and what came of it, as certificates hold it.
#pragma once

#include <map>
#include <string>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::apps {

// Returns the options of the certificate, by name.
std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome);

// Returns what a comment in the mesh's files says: nothing of a certified mesh, else what is
// missing.
std::string file_note_of(const certificate& claim);

}  // namespace asterism::apps
