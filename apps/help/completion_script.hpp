// SPDX-License-Identifier: MIT
//
// Writes completion scripts for shells.
#pragma once

#include <string>
#include <vector>

#include "asterism/apps/help/command_tree.hpp"

namespace asterism::apps {

// Returns the completion script of a shell: "bash", "zsh" or "fish".
std::string completion_script(const std::vector<command_entry>& tree, const std::string& shell);

}  // namespace asterism::apps
