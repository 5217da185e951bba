// SPDX-License-Identifier: MIT
//
// Reads the usual form of a section of a text file, by several threads: each record on a line of
// its own, which has the record's numbers and nothing else. A section of another form is read word
// by word; so are the words of an error.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

// Takes numbers from the beginning of a text. A number that is not plainly spelled, or that its
// type does not hold, is not taken: a sign `+`, Fortran's exponents, hexadecimal numbers, infinity.
class number_line {
 public:
  explicit number_line(std::string_view text)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  // Takes the next number of the line; returns false where there is none.
  bool take(double& value);
  bool take(long long& value);
  // Goes to the next line; returns false if this one has more than blanks.
  bool end();
  // Returns the number of bytes before the present place.
  std::size_t passed() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  void skip_blanks();
  bool is_between_words(const char* at) const;

  const char *begin_, *at_, *end_;
};

// Lines `first` to `first + count`, at the beginning of `text`.
struct part_of_lines {
  std::string_view text;
  std::size_t first, count;
};

// Divides the first `count` lines of a text for several threads; returns one part for one thread.
std::vector<part_of_lines> divide_lines(std::string_view text, std::size_t count);

// Calls take(i, line) for the line of each of `count` records, which begin on the next line, in any
// order and by several threads. If each call returns true and nothing is left on any line,
// continues after them and returns true. Otherwise returns false, and the scanner is where it was.
template <class Take>
bool take_plain_lines(text_scanner& source, std::size_t count, const Take& take) {
  const auto lines = source.next_lines();
  if (!lines || count == 0) return false;
  const std::vector<part_of_lines> parts = divide_lines(*lines, count);
  std::vector<std::size_t> passed(parts.size(), 0);  // 0 where a line has another form
  parallel_chunks(parts.size(), 1, [&](std::size_t p, std::size_t, std::size_t) {
    number_line line(parts[p].text);
    for (std::size_t i = 0; i < parts[p].count; ++i)
      if (!take(parts[p].first + i, line) || !line.end()) return;
    passed[p] = line.passed();
  });
  for (const std::size_t bytes : passed)
    if (bytes == 0) return false;
  const char* const end = parts.back().text.data() + passed.back();
  source.pass_over(static_cast<std::size_t>(end - lines->data()), count);
  return true;
}

}  // namespace asterism::internal
