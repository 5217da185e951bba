// SPDX-License-Identifier: MIT
//
// Checks the places where files are to be written, before any work is done.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::apps {

// Returns the files that are read for `mesh`: the file itself, and for Medit's formats the metric
// beside it, if there is one.
std::vector<std::filesystem::path> files_read_with(const std::filesystem::path& mesh);

// Refuses a file that would be written twice, or that is also read, however its path is spelled.
// One file may be read for several purposes.
std::optional<error> check_distinct(const std::vector<std::filesystem::path>& read,
                                    const std::vector<std::filesystem::path>& written);

}  // namespace asterism::apps
