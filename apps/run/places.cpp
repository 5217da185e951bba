// SPDX-License-Identifier: MIT
#include "asterism/apps/run/places.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;

namespace {

// True if a file can be created there: a file system may forbid what the permissions of the folder
// allow.
bool takes_files(const fs::path& folder) {
  std::string name = (folder / ".asterism-XXXXXX").string();
  const int made = mkstemp(name.data());
  if (made < 0) return false;
  close(made);
  unlink(name.c_str());
  return true;
}

}  // namespace

std::optional<error> check_place(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    return error{path.string() + ": there is no directory " + folder.string(),
                 error_code::unwritable_file};
  if (access(folder.c_str(), W_OK | X_OK) != 0 || !takes_files(folder))
    return error{path.string() + ": directory " + folder.string() + " is not writable",
                 error_code::unwritable_file};
  if (!path.has_filename() || (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)))
    return error{path.string() + ": not a regular file", error_code::unwritable_file};
  return std::nullopt;
}

std::vector<fs::path> files_read_with(const fs::path& mesh) {
  std::vector<fs::path> files = {mesh};
  const bool is_binary = has_ending(mesh.string(), ".meshb");
  if (!is_binary && !has_ending(mesh.string(), ".mesh")) return files;
  std::error_code ignored;
  fs::path beside = solution_path(mesh);
  if (is_binary && !fs::exists(beside, ignored)) beside.replace_extension(".sol");
  if (fs::is_regular_file(beside, ignored)) files.push_back(std::move(beside));
  return files;
}

std::optional<error> check_distinct(const std::vector<fs::path>& read,
                                    const std::vector<fs::path>& written) {
  const auto place_of = [](const fs::path& path) {
    std::error_code failure;
    fs::path place = fs::weakly_canonical(fs::absolute(path, failure), failure);
    return failure ? path : place;
  };
  std::vector<fs::path> seen;
  for (const fs::path& path : read) seen.push_back(place_of(path));
  for (const fs::path& path : written) {
    fs::path place = place_of(path);
    if (std::find(seen.begin(), seen.end(), place) != seen.end())
      return error{path.string() + ": this file would be used twice", error_code::unwritable_file};
    seen.push_back(std::move(place));
  }
  return std::nullopt;
}

}  // namespace asterism::apps
