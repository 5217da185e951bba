// SPDX-License-Identifier: MIT
//
// Finds the kind of a file by the ending of its name, in any case: PART.POLY is a .poly file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace asterism::internal {

// Returns the lower-case letter, independent of the locale, unlike std::tolower.
inline char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// True if the name ends with `ending`, which is in lower case, with its dot.
inline bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         std::equal(ending.begin(), ending.end(),
                    name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char wanted, char c) { return wanted == lower_case(c); });
}

}  // namespace asterism::internal
