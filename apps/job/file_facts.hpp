// SPDX-License-Identifier: MIT
//
// Lists the contents of a file, without judging it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::apps {

// Facts in order: a name such as "vertices", and a count, or words.
using file_facts = std::vector<std::pair<std::string, std::variant<std::string, std::size_t>>>;

// Reads a domain, a mesh (with what is beside it), a solution or metric (with the mesh beside it)
// or a certificate. Fails where the file cannot be read, or is none of these.
result<file_facts> facts_of_file(const std::filesystem::path& path);

}  // namespace asterism::apps
