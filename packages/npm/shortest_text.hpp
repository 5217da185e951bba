// SPDX-License-Identifier: MIT
//
// Writes the shortest text of a double by the C library's functions, for standard libraries whose
// std::to_chars takes no doubles. The text is the same for every number.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace asterism::internal {

using text_of_double = std::array<char, 400>;  // more than the largest double has before the point

// Adds one unit in the last digit to the number in scientific notation. No carry goes beyond the
// first digit here.
inline void count_up(text_of_double& text) {
  char* digit = std::strchr(text.data(), 'e') - 1;
  for (; *digit == '9'; digit -= digit[-1] == '.' ? 2 : 1) *digit = '0';
  ++*digit;
}

// Writes the fewest digits of scientific notation that are read as `value` again, and returns their
// number. A normal number that fewer than fifteen digits determine is written by fifteen digits
// with zeros at their end. Below a power of two doubles are nearer than above it. There the decimal
// above the nearest one may be read as `value` when the nearest one is not.
inline int shortest_scientific(text_of_double& text, double value) {
  constexpr int surely_kept = 15, surely_enough = 17;
  const auto is_read = [&] { return std::strtod(text.data(), nullptr) == value; };
  const auto write = [&](int digits) {
    std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
  };
  if (!std::isnormal(value)) {
    int digits = 1;
    for (write(digits); digits < surely_enough && !is_read();) write(++digits);
    return digits;
  }
  write(surely_kept);
  if (is_read()) {
    int digits = surely_kept;
    const char* last = std::strchr(text.data(), 'e') - 1;
    for (; digits > 1 && *last == '0'; --last) --digits;
    write(digits);
    return digits;
  }
  write(surely_kept + 1);
  if (is_read()) return surely_kept + 1;
  int exponent = 0;
  if (std::frexp(std::fabs(value), &exponent) == 0.5) {
    count_up(text);
    if (is_read()) return surely_kept + 1;
  }
  write(surely_enough);
  return surely_enough;
}

// Returns the fewest characters that are read as `value` again, in fixed notation where it is not
// longer.
inline std::string shortest_text(double value) {
  text_of_double text;
  if (!std::isfinite(value)) {
    std::snprintf(text.data(), text.size(), "%f", value);
    return text.data();
  }
  const int digits = shortest_scientific(text, value);
  const int exponent = std::atoi(std::strchr(text.data(), 'e') + 1);
  const int scientific = static_cast<int>(std::strlen(text.data())) - (std::signbit(value) ? 1 : 0);
  const int places = std::max(digits - 1 - exponent, 0);  // digits behind the point
  const int fixed = std::max(exponent, 0) + 1 + (places > 0 ? 1 : 0) + places;
  if (fixed <= scientific) std::snprintf(text.data(), text.size(), "%.*f", places, value);
  return text.data();
}

}  // namespace asterism::internal
