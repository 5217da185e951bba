// SPDX-License-Identifier: MIT
//
// Lists numbers in a message, as that of a marker that no segment has.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace asterism::internal {

// Returns the first ten numbers, with ", ..." after them if there are others; "none" of none.
inline std::string first_numbers(const std::set<int>& numbers) {
  constexpr std::size_t most = 10;
  std::string text;
  std::size_t count = 0;
  for (const int n : numbers) {
    if (count++ == most) return text + ", ...";
    if (!text.empty()) text += ", ";
    text += std::to_string(n);
  }
  return text.empty() ? "none" : text;
}

}  // namespace asterism::internal
