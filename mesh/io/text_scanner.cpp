// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Returns a number in Fortran's spelling, 1.5D+00 or 1.5+100, with the exponent letter e. Returns
// nothing for other spellings.
std::string with_plain_exponent(std::string_view number) {
  constexpr std::string_view marks = "dD";
  std::string plain(number);
  if (const std::size_t at = number.find_first_of(marks); at != std::string_view::npos) {
    plain[at] = 'e';
    return at > 0 && (is_digit(number[at - 1]) || number[at - 1] == '.') ? plain : std::string();
  }
  // Finds the exponent's sign: three digits leave no room for a letter, and a point is always
  // there.
  const std::size_t at = number.find_last_of("+-");
  if (at == std::string_view::npos || at < 2 || number.size() - at != 4 || number.find('.') > at ||
      !is_digit(number[at + 1]))
    return {};
  return plain.insert(at, 1, 'e');
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

}  // namespace

std::string without_controls(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

void text_scanner::skip_blanks(bool across_lines) {
  while (!at_end()) {
    const char c = text_[position_];
    if (c == comment_mark_ && c != '\0') {
      const std::size_t end = std::min(text_.find('\n', position_), text_.size());
      comments_.push_back(text_.substr(position_ + 1, end - position_ - 1));
      position_ = end;
    } else if (c == '\n' && across_lines) {
      ++line_;
      ++position_;
    } else if (is_blank(c)) {
      ++position_;
    } else {
      return;
    }
  }
}

word text_scanner::next() {
  skip_blanks(true);
  const std::size_t begin = position_;
  while (!at_end() && !is_blank(text_[position_]) && text_[position_] != '\n' &&
         (text_[position_] != comment_mark_ || comment_mark_ == '\0'))
    ++position_;
  return {text_.substr(begin, position_ - begin), line_};
}

std::vector<word> text_scanner::next_line() {
  std::vector<word> words;
  next_line(words);
  return words;
}

void text_scanner::next_line(std::vector<word>& words) {
  words.clear();
  for (word w = next(); !w.empty(); w = next()) {
    words.push_back(w);
    skip_blanks(false);
    if (at_end() || text_[position_] == '\n') break;
  }
}

std::string_view text_scanner::rest_of_line() {
  const std::size_t begin = position_, end = std::min(text_.find('\n', position_), text_.size());
  position_ = end;
  if (!at_end()) {
    ++position_;
    ++line_;
  }
  std::string_view rest = text_.substr(begin, end - begin);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  return rest;
}

std::string_view text_scanner::take_bytes(std::size_t count) {
  const std::string_view bytes = text_.substr(position_, count);
  position_ += bytes.size();
  return bytes;
}

std::optional<std::string_view> text_scanner::next_lines() const {
  std::size_t at = position_;
  while (at < text_.size() && is_blank(text_[at])) ++at;
  if (at == text_.size() || text_[at] != '\n') return std::nullopt;
  return text_.substr(at + 1);
}

void text_scanner::pass_over(std::size_t bytes, std::size_t lines) {
  position_ = text_.find('\n', position_) + 1 + bytes;
  const bool is_ended = text_[position_ - 1] == '\n';
  line_ += is_ended ? 1 + lines : lines;
}

error text_scanner::failure(std::size_t line, const std::string& what, error_code code) const {
  return {file_ + ":" + std::to_string(line) + ": " + without_controls(what), code};
}

result<double> to_number(const text_scanner& source, const word& w, std::string_view meaning) {
  if (w.empty()) return source.failure(w.line, std::string(meaning) + ": the file ends here");
  const result<double> value = parse_number(w.text);
  if (value.ok()) return value.value();
  if (const std::string plain = with_plain_exponent(w.text); !plain.empty())
    if (const result<double> other = parse_number(plain); other.ok()) return other.value();
  return source.failure(w.line, value.failure().at(std::string(meaning)).message,
                        value.failure().code);
}

result<point> to_point(const text_scanner& source, const word& x, const word& y,
                       std::string_view of) {
  const auto first = to_number(source, x, "x of " + std::string(of));
  if (!first) return first.failure();
  const auto second = to_number(source, y, "y of " + std::string(of));
  if (!second) return second.failure();
  return point{first.value(), second.value()};
}

result<long long> to_integer(const text_scanner& source, const word& w, std::string_view meaning) {
  if (w.empty()) return source.failure(w.line, std::string(meaning) + ": the file ends here");
  std::string_view digits = w.text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  long long value = 0;
  const char* const end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, value);
  const bool too_large = read.ec == std::errc::result_out_of_range;
  if (read.ptr != end || (read.ec != std::errc() && !too_large))
    return source.failure(
        w.line, std::string(meaning) + ": " + quoted_token(w.text) + " is not a whole number",
        error_code::bad_number);
  if (too_large)
    return source.failure(w.line,
                          std::string(meaning) + ": " + quoted_token(w.text) + " is too large",
                          error_code::bad_number);
  return value;
}

result<int> to_marker(const text_scanner& source, const word& w, std::string_view meaning) {
  const auto value = to_integer(source, w, meaning);
  if (!value.ok()) return value.failure();
  if (value.value() < std::numeric_limits<int>::min() ||
      value.value() > std::numeric_limits<int>::max())
    return source.failure(
        w.line, std::string(meaning) + ": " + quoted_token(w.text) + " does not fit into 32 bits",
        error_code::bad_number);
  return static_cast<int>(value.value());
}

result<std::size_t> to_count(const text_scanner& source, const word& w, std::string_view meaning) {
  const auto value = to_integer(source, w, meaning);
  if (!value.ok()) return value.failure();
  if (value.value() < 0)
    return source.failure(w.line,
                          std::string(meaning) + ": " + quoted_token(w.text) + " is negative");
  const auto count = static_cast<unsigned long long>(value.value());
  if (count > source.remaining() / 2 + 1)
    return source.failure(w.line, std::string(meaning) + ": " + quoted_token(w.text) +
                                      " is more than the rest of the file can hold");
  return static_cast<std::size_t>(count);
}

}  // namespace asterism::internal
