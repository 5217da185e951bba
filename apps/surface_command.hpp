// SPDX-License-Identifier: MIT
//
// Declares the subcommand for surfaces in space, as apps/commands.hpp does the others.
#pragma once

#include "asterism/apps/commands.hpp"

namespace asterism::apps {

void add_surface_command(CLI::App& program, command& chosen);

}  // namespace asterism::apps
