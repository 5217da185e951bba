// SPDX-License-Identifier: MIT
//
// Verifies a folder of pieces: each piece, and that together they are a mesh of the domain.
#pragma once

#include "asterism/apps/pieces/piece_team.hpp"
#include "asterism/apps/text/verify_question.hpp"

namespace asterism::apps {

// True if the options name a folder of a mesh in pieces.
bool is_of_pieces(const verify_options& options);

// Returns the exit status, the same for all members of the team; a null team stands for a team of
// one.
int run_verify_pieces(const verify_options& options, piece_team* team);

}  // namespace asterism::apps
