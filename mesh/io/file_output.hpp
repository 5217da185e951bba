// SPDX-License-Identifier: MIT
//
// Writes files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

struct output_file {
  std::filesystem::path path;
  std::string bytes;
};

// Writes every file under a temporary name beside its place (`.part` appended, and a number if that
// is taken), then renames them in order; existing files are replaced. When anything fails before
// the first renaming nothing is changed and nothing stays behind; the error names the file and the
// system's reason. Returns the paths.
result<std::vector<std::filesystem::path>> write_files(const std::vector<output_file>& files);

// Checks that the directory of `path` exists and can be written to, and that `path` itself is free
// or a regular file. Returns `path`.
result<std::filesystem::path> check_writable(const std::filesystem::path& path);

}  // namespace asterism::internal
