// SPDX-License-Identifier: MIT
//
// Returns the words of a mesh job in its certificate: options and outcome.
#pragma once

#include <map>
#include <string>

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::apps {

// Returns the options for the certificate, by name.
std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome);

// Returns the comment for the mesh's files: empty for a certified mesh, else the reason why it is
// none.
std::string file_note_of(const certificate& claim);

}  // namespace asterism::apps
