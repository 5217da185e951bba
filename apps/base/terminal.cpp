// SPDX-License-Identifier: MIT
#include "asterism/apps/base/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace asterism::apps {
namespace {

bool has_colours(int stream) {
  const char* const refused = std::getenv("NO_COLOR");
  const char* const kind = std::getenv("TERM");
  return isatty(stream) != 0 && (refused == nullptr || *refused == '\0') && kind != nullptr &&
         std::string_view(kind) != "dumb";
}

}  // namespace

std::string in_colour(const std::string& text, ink colour, int stream) {
  if (!has_colours(stream)) return text;
  const char* const code = colour == ink::red ? "31" : colour == ink::green ? "32" : "33";
  return std::string("\033[1;") + code + "m" + text + "\033[0m";
}

}  // namespace asterism::apps
