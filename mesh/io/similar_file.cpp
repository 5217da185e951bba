// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/similar_file.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "asterism/core/similar_name.hpp"

namespace asterism::internal {
namespace {

namespace fs = std::filesystem;

// Returns the names of a folder's files in alphabetical order: systems list them in any order.
// Returns none of a folder with too many.
std::vector<std::string> names_in(const fs::path& folder,
                                  const std::function<bool(std::string_view)>& fits) {
  constexpr std::size_t most = 10000;
  std::vector<std::string> names;
  std::error_code failed;
  std::size_t entries = 0;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (++entries > most) return {};
    std::string name = at->path().filename().string();
    std::error_code ignored;
    if ((!fits || fits(name)) && at->is_regular_file(ignored)) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string similar_file(const fs::path& path, const std::function<bool(std::string_view)>& fits) {
  const fs::path folder = path.parent_path();
  const std::string word = path.filename().string();
  const std::string name = similar_name(word, names_in(folder.empty() ? "." : folder, fits));
  return name.empty() ? "" : "; did you mean " + (folder / name).string() + "?";
}

}  // namespace asterism::internal
