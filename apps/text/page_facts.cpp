// SPDX-License-Identifier: MIT
#include "asterism/apps/text/page_facts.hpp"

#include <algorithm>

#include "asterism/mesh/io/file_ending.hpp"

namespace asterism::apps {
namespace fs = std::filesystem;
using internal::has_ending;
namespace {

// Quotes a word for a POSIX shell: in single quotes where any character has a special meaning.
std::string quoted(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+,:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string shell_words(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    line += quoted(word);
  }
  return line;
}

bool has_page(const std::vector<fs::path>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(),
                     [](const fs::path& path) { return has_ending(path.string(), ".html"); });
}

std::string repeating_command(const std::vector<fs::path>& outputs, const fs::path& certificate) {
  const auto mesh_file = std::find_if(outputs.begin(), outputs.end(), [](const fs::path& path) {
    return has_ending(path.string(), ".mesh");
  });
  if (mesh_file == outputs.end())
    return "# No .mesh was written beside this page: the same command with -o NAME.mesh gives "
           "one.\n"
           "asterism verify NAME.mesh --certificate " +
           quoted(certificate.string());
  return shell_words(
      {"asterism", "verify", mesh_file->string(), "--certificate", certificate.string()});
}

std::vector<metric_tensor> tensors_at_sites(const metric_field& field, const mesh& m) {
  std::vector<metric_tensor> tensors;
  tensors.reserve(m.sites.size());
  for (const site& s : m.sites) {
    const auto there = field.at(s.position);
    if (!there) return {};
    tensors.push_back(there.value());
  }
  return tensors;
}

}  // namespace asterism::apps
