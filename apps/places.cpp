// SPDX-License-Identifier: MIT
#include "asterism/apps/places.hpp"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <system_error>

namespace asterism::apps {
namespace fs = std::filesystem;

std::optional<error> check_place(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    return error{path.string() + ": there is no directory " + folder.string(),
                 error_code::unwritable_file};
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    return error{path.string() + ": directory " + folder.string() + " is not writable",
                 error_code::unwritable_file};
  if (!path.has_filename() || (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)))
    return error{path.string() + ": not a regular file", error_code::unwritable_file};
  return std::nullopt;
}

std::optional<error> check_distinct(const std::vector<fs::path>& paths) {
  std::vector<fs::path> seen;
  for (const fs::path& path : paths) {
    std::error_code failure;
    fs::path place = fs::weakly_canonical(fs::absolute(path), failure);
    if (failure) place = path;
    if (std::find(seen.begin(), seen.end(), place) != seen.end())
      return error{path.string() + ": this file would be used twice", error_code::unwritable_file};
    seen.push_back(std::move(place));
  }
  return std::nullopt;
}

}  // namespace asterism::apps
