// SPDX-License-Identifier: MIT
//
// Writes files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// Function that takes the bytes of a file, piece by piece.
using byte_sink = std::function<void(std::string_view)>;

// Returns the place of a file with this name: symbolic links are followed to their end, which need
// not exist.
std::filesystem::path place_of(const std::filesystem::path& path);

// Returns all bytes that `write` gives to a sink.
std::string bytes_of(const std::function<void(const byte_sink&)>& write);

struct output_file {
  std::filesystem::path path;
  std::string bytes = {};
  // Function that gives the bytes after `bytes`, if it is set: it makes them while the file is
  // written, so that a long file is never held whole. Data that it refers to must live until then.
  std::function<void(const byte_sink&)> rest = {};
};

// Files of one run, which appear together or not at all. Each is written under a temporary name
// beside its place (`.part` appended, and a number if that is taken); put_in_place() renames them
// all. A process that is killed by force, or a machine that stops, between two renamings leaves
// some new files and some old.
class pending_files {
 public:
  pending_files() = default;
  // Removes the temporary files that were not renamed.
  ~pending_files();
  pending_files(const pending_files&) = delete;
  pending_files& operator=(const pending_files&) = delete;

  // Writes the bytes under a temporary name and frees them. The error names the file and the
  // system's reason.
  std::optional<error> add(const output_file& file);
  // Renames the files to their places in the order in which they were added, and returns the paths;
  // existing files are replaced, but a directory is not. Files that are replaced have a second name
  // meanwhile (`.old`). If a renaming fails, those made before are undone, and nothing is changed.
  result<std::vector<std::filesystem::path>> put_in_place();

 private:
  std::vector<std::filesystem::path> places_, temporary_;
};

// Writes all of the files, or none. Returns their paths.
result<std::vector<std::filesystem::path>> write_files(const std::vector<output_file>& files);

// Checks all that is known of a place without creating a file there: its directory exists, its
// permissions allow files, and the place is free or has a regular file.
std::optional<error> check_place(const std::filesystem::path& place);

// Checks that the directory of `path`, links followed, exists and can be written to, and that
// `path` itself is free or a regular file. Returns `path`.
result<std::filesystem::path> check_writable(const std::filesystem::path& path);

// Checks all of the files. Creates one file in each directory, not one for each of them.
std::optional<error> check_all_writable(const std::vector<std::filesystem::path>& files);

}  // namespace asterism::internal
