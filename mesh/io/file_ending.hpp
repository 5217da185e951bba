// SPDX-License-Identifier: MIT
//
// Tells the kind of a file by the end of its name, in any case: PART.POLY is a .poly file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace asterism::internal {

// Replaces std::tolower, whose answer depends on the locale.
inline char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// True if the name ends so. `ending` is in lower case, with its dot.
inline bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         std::equal(ending.begin(), ending.end(),
                    name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char wanted, char c) { return wanted == lower_case(c); });
}

}  // namespace asterism::internal
