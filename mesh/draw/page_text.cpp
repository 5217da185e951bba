// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/page_text.hpp"

namespace asterism::internal {

std::string for_script(std::string text) {
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1))
    text.replace(at, 1, "\\u003c");
  return text;
}

std::string fill_in(std::string_view page,
                    const std::vector<std::pair<std::string_view, std::string_view>>& values) {
  std::string filled;
  while (!page.empty()) {
    const std::size_t open = page.find("{{");
    filled += page.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = page.find("}}", open);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    for (const auto& [known, value] : values)
      if (known == name) filled += value;
    page.remove_prefix(close + 2);
  }
  return filled;
}

}  // namespace asterism::internal
