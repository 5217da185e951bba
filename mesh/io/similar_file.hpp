// SPDX-License-Identifier: MIT
//
// Finds the file that a mistyped name stands for, for messages.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace asterism::internal {

// Returns the clause "; did you mean FOLDER/NAME?" about a file of the same folder with a similar
// name; empty if there is none, or if the folder is too large to be searched. Considers only files
// whose name fits, where `fits` is given.
std::string similar_file(const std::filesystem::path& path,
                         const std::function<bool(std::string_view)>& fits = {});

}  // namespace asterism::internal
