// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace asterism::internal {

// Returns the text escaped for XML and HTML, between tags and in attributes with double quotes.
inline std::string escaped_markup(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace asterism::internal
