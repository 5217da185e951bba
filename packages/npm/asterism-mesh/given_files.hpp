// SPDX-License-Identifier: MIT
//
// The files that JavaScript hands to a job: a module has no others.
#pragma once

#include <string>

namespace asterism::internal {

// Has read_text_file (mesh/io/text_scanner.hpp) find `text` under `name`.
void give_file(const std::string& name, std::string text);

}  // namespace asterism::internal
