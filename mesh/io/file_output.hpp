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
// is taken), then renames them in order; existing files are replaced. Whatever fails, the error
// names the file and the system's reason, nothing is changed and nothing stays behind: files that
// are replaced have a second name meanwhile (`.old`), from which those already renamed are put
// back. A process that is killed by force, or a machine that stops, between two renamings leaves
// some new files and some old. Returns the paths.
result<std::vector<std::filesystem::path>> write_files(const std::vector<output_file>& files);

// Checks that the directory of `path` exists and can be written to, and that `path` itself is free
// or a regular file. Returns `path`.
result<std::filesystem::path> check_writable(const std::filesystem::path& path);

}  // namespace asterism::internal
