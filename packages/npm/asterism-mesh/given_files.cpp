// SPDX-License-Identifier: MIT
#include "asterism/packages/npm/asterism-mesh/given_files.hpp"

#include <map>
#include <string_view>
#include <utility>

#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

std::map<std::string, std::string>& files() {
  static std::map<std::string, std::string> all;
  return all;
}

}  // namespace

void give_file(const std::string& name, std::string text) { files()[name] = std::move(text); }

// Stands in for mesh/io/text_scanner_files.cpp.
result<std::string> read_text_file(const std::filesystem::path& path) {
  const auto found = files().find(path.string());
  if (found == files().end())
    return error{path.string() + ": no such file was given", error_code::unreadable_file};
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string& text = found->second;
  return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

}  // namespace asterism::internal
