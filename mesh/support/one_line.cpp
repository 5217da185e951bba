// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/one_line.hpp"

#include <algorithm>
#include <cstdint>

namespace asterism::internal {
namespace {

constexpr std::size_t longest_word = 240, kept_before = 100, kept_after = 60;

bool goes_on_character(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

// A character of UTF-8, or one byte that begins none.
struct character {
  std::uint32_t code = 0;  // of a byte that begins none: the byte itself
  std::size_t bytes = 1;
};

character first_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 1;
  if (bytes == 1 || first > 0xf4 || text.size() < bytes) return {first, 1};
  std::uint32_t code = first & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!goes_on_character(text[i])) return {first, 1};
    code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
  }
  return {code, bytes};
}

bool is_obeyed(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x061c || code == 0x200e ||
         code == 0x200f || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

// Appends a word, its middle left out where it is too long. No character is divided.
void append_word(std::string& line, std::string_view word) {
  if (word.size() <= longest_word) {
    line += word;
    return;
  }
  std::size_t end = kept_before, begin = word.size() - kept_after;
  while (end > 0 && goes_on_character(word[end])) --end;
  while (begin < word.size() && goes_on_character(word[begin])) ++begin;
  line.append(word.substr(0, end)).append("...").append(word.substr(begin));
}

}  // namespace

std::size_t first_character_bytes(std::string_view text) { return first_character(text).bytes; }

std::string printable(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const character next = first_character(text);
    if (is_obeyed(next.code))
      safe += '?';
    else
      safe += text.substr(0, next.bytes);
    text.remove_prefix(next.bytes);
  }
  return safe;
}

std::string one_line(std::string_view text) {
  const std::string safe = printable(text);
  std::string_view rest = safe;
  std::string line;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    append_word(line, rest.substr(0, end));
    if (end < rest.size()) line += ' ';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return line;
}

}  // namespace asterism::internal
