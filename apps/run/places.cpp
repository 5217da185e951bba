// SPDX-License-Identifier: MIT
#include "asterism/apps/run/places.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;

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
