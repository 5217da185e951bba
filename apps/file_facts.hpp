// SPDX-License-Identifier: MIT
//
// Says what a file holds, without judging it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::apps {

// Facts in the order in which they are told: a name such as "vertices", and a value in words.
using file_facts = std::vector<std::pair<std::string, std::string>>;

// Reads a domain, a mesh (with what is beside it) or a certificate. Fails where the file cannot be
// read, or is none of these.
result<file_facts> facts_of_file(const std::filesystem::path& path);

}  // namespace asterism::apps
