// SPDX-License-Identifier: MIT
//
// Writes manual pages.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/apps/help/command_tree.hpp"

namespace asterism::apps {

// Returns the manual page of the entry `which`, in the macros of man(7).
std::string manual_page(const std::vector<command_entry>& tree, std::size_t which);

}  // namespace asterism::apps
