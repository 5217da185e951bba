// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/plain_lines.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "asterism/core/double_reader.hpp"

namespace asterism::internal {
namespace {

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::size_t count_ends(std::string_view text) {
  std::size_t ends = 0;
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    ++ends;
  return ends;
}

constexpr std::size_t bytes_of_part = 1 << 16;

// Returns the number of ends of lines before each part of a text, up to the part in which line
// `count` begins.
std::vector<std::size_t> ends_before_parts(std::string_view text, std::size_t count) {
  constexpr std::size_t at_once = 64;  // parts: the rest of the file may be much longer
  const std::size_t parts = chunk_count(text.size(), bytes_of_part);
  std::vector<std::size_t> before{0};
  while (before.size() <= parts && before.back() < count) {
    const std::size_t first = before.size() - 1, more = std::min(at_once, parts - first);
    before.resize(before.size() + more);
    parallel_for(more, [&](std::size_t i) {
      before[first + i + 1] = count_ends(text.substr((first + i) * bytes_of_part, bytes_of_part));
    });
    for (std::size_t i = first; i < first + more; ++i) before[i + 1] += before[i];
  }
  return before;
}

}  // namespace

void number_line::skip_blanks() {
  while (at_ != end_ && is_space(*at_)) ++at_;
}

bool number_line::is_between_words(const char* at) const {
  return at == end_ || is_space(*at) || *at == '\n';
}

bool number_line::take(double& value) {
  skip_blanks();
  const char* first = at_;
  if (first != end_ && *first == '-') ++first;
  if (first == end_ || (!is_decimal(*first) && *first != '.')) return false;
  const auto read = read_double(at_, end_, value, false);
  if (read.ec != std::errc() || !std::isfinite(value) || !is_between_words(read.ptr)) return false;
  at_ = read.ptr;
  return true;
}

bool number_line::take(long long& value) {
  constexpr std::ptrdiff_t most_digits = 18;  // 64 bits hold each number of 18 digits
  skip_blanks();
  const bool is_negative = at_ != end_ && *at_ == '-';
  const char* const first = is_negative ? at_ + 1 : at_;
  const char* at = first;
  long long read = 0;
  for (; at != end_ && is_decimal(*at) && at - first < most_digits; ++at)
    read = 10 * read + (*at - '0');
  if (at == first || !is_between_words(at)) return false;
  value = is_negative ? -read : read;
  at_ = at;
  return true;
}

bool number_line::end() {
  skip_blanks();
  if (at_ == end_) return true;
  if (*at_ != '\n') return false;
  ++at_;
  return true;
}

std::vector<part_of_lines> divide_lines(std::string_view text, std::size_t count) {
  if (text.size() <= bytes_of_part || thread_count() == 1) return {{text, 0, count}};
  const std::vector<std::size_t> before = ends_before_parts(text, count);
  std::vector<part_of_lines> parts{{text, 0, count}};
  for (std::size_t p = 1; p < before.size() && before[p] < count; ++p) {
    // Finds the end of the line that has the last byte before this part.
    const std::size_t last = p * bytes_of_part - 1;
    const std::size_t end = text.find('\n', last);
    const std::size_t line = before[p] + (end == last ? 0 : 1);
    // Leaves out a part in which no line begins.
    if (end == std::string_view::npos || end >= last + bytes_of_part || line >= count) continue;
    parts.back().count = line - parts.back().first;
    parts.push_back({text.substr(end + 1), line, count - line});
  }
  return parts;
}

}  // namespace asterism::internal
