// SPDX-License-Identifier: MIT
//
// Declares the subcommand for surfaces in space, as apps/base/commands.hpp does the others.
#pragma once

#include "asterism/apps/base/commands.hpp"

namespace asterism::apps {

void add_surface_command(CLI::App& program, command& chosen);

}  // namespace asterism::apps
