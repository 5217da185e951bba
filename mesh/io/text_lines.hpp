// SPDX-License-Identifier: MIT
//
// Makes text of many lines in parallel, the same for any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

// Appends the shortest text that is read as the same double again: all numbers of text files.
inline void append_number(std::string& text, double x) {
  std::array<char, 32> digits;  // sign, 17 digits, point, exponent of five
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  text.append(digits.data(), end.ptr);
}

template <class Integer>
void append_integer(std::string& text, Integer n) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), n);
  text.append(digits.data(), end.ptr);
}

// Appends a line of integers.
template <class First, class... Rest>
void append_words(std::string& text, First first, Rest... rest) {
  append_integer(text, first);
  ((text += ' ', append_integer(text, rest)), ...);
  text += '\n';
}

inline constexpr std::size_t lines_of_a_part = 2048;

// Calls take(part) with the text that line(i, text) appends, for i in [0, count), part by part in
// order, from any thread. Makes a few parts at a time, so that little memory is held, while one
// thread takes those made before: writing them takes about as long as making them by two threads.
// With one thread makes one at a time, as each part takes new memory.
template <class Line, class Take>
void make_lines(std::size_t count, const Line& line, const Take& take) {
  constexpr std::size_t chunk = lines_of_a_part, most_parts = 16;
  const std::size_t at_a_time = chunk * (thread_count() > 1 ? most_parts : 1);
  std::vector<std::string> made(std::min(at_a_time, count) / chunk + 1), before(made.size());
  std::size_t parts_before = 0;
  const auto take_before = [&] {
    for (std::size_t i = 0; i < parts_before; ++i) take(before[i]);
  };
  for (std::size_t first = 0; first < count; first += at_a_time) {
    const std::size_t lines = std::min(at_a_time, count - first), parts = chunk_count(lines, chunk);
    parallel_for(1 + parts, [&](std::size_t item) {
      if (item == 0) return take_before();
      // Appends to a string of this thread's own. Those of the list share cache lines, and each
      // line of text changes the length of one.
      std::string part = std::move(made[item - 1]);
      part.clear();
      const std::size_t begin = first + (item - 1) * chunk;
      for (std::size_t k = begin; k < std::min(begin + chunk, first + lines); ++k) line(k, part);
      made[item - 1] = std::move(part);
    });
    made.swap(before);
    parts_before = parts;
  }
  take_before();
}

// Appends the text of all lines to a text.
template <class Line>
void append_lines(std::string& text, std::size_t count, const Line& line) {
  constexpr std::size_t beginning = 16384;  // lines
  const std::size_t before = text.size();
  std::size_t parts = 0;
  make_lines(count, line, [&](const std::string& part) {
    text += part;
    const std::size_t lines = ++parts * lines_of_a_part;
    // Reserves room for the remaining lines, assuming that they are as long as the first ones, and
    // a little more.
    if (lines == beginning && lines < count)
      text.reserve(before + static_cast<std::size_t>(
                                1.1 * static_cast<double>(text.size() - before) *
                                static_cast<double>(count) / static_cast<double>(lines)));
  });
}

}  // namespace asterism::internal
