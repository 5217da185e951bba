// SPDX-License-Identifier: MIT
//
// Runs a mesh job in pieces: cuts the domain, meshes the pieces in rounds until their seams agree,
// and writes each with its certificate, the index last.
#pragma once

#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/pieces/piece_team.hpp"

namespace asterism::apps {

// Returns the exit status, the same for all members of the team; a null team stands for a team of
// one. The files do not depend on the team.
int run_pieces_job(const mesh_job& job, piece_team* team);

}  // namespace asterism::apps
