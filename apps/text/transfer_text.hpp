// SPDX-License-Identifier: MIT
//
// Adds the option of how a solution is transferred, and returns texts on the transfer.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::apps {

// Adds --transfer.
void add_transfer_option(CLI::App& app, transfer_method& how);

// Returns a line for the meshes and one for each component.
std::string text_of(const transfer_report& report);

}  // namespace asterism::apps
