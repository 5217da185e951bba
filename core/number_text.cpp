// SPDX-License-Identifier: MIT
#include "asterism/core/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "asterism/core/double_reader.hpp"

namespace asterism::internal {

std::string quoted_token(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : token.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > longest ? "...'" : "'");
}

// Returns words in place of infinity and NaN, which come from numbers that are too large.
std::string format_number(double value) {
  if (std::isnan(value)) return "unknown";
  if (std::isinf(value)) return value > 0 ? "too large" : "too far below 0";
  constexpr int digits = 6;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::general, digits);
  return {text.data(), written.ptr};
}

namespace {

// True if a number that no double holds is too large rather than too small. `digits` has no sign
// and no base prefix and was read by from_chars; `base` is 10 or 16.
bool is_huge(std::string_view digits, int base) {
  const std::string_view exponent_mark = base == 16 ? "pP" : "eE";
  const std::size_t mark = std::min(digits.find_first_of(exponent_mark), digits.size());
  const std::string_view mantissa = digits.substr(0, mark);
  const std::size_t leading = mantissa.find_first_not_of("0.");
  if (leading == std::string_view::npos) return false;
  std::string_view exponent = digits.substr(std::min(mark + 1, digits.size()));
  const bool negative = !exponent.empty() && exponent.front() == '-';
  if (!exponent.empty() && (negative || exponent.front() == '+')) exponent.remove_prefix(1);
  long long power = 0;
  const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  // Bounds the exponent: no text is long enough to compensate for it.
  constexpr long long beyond_any_text = 1LL << 60;
  if (read.ec == std::errc::result_out_of_range || power > beyond_any_text) return !negative;
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  const long long places = static_cast<long long>(dot) - static_cast<long long>(leading);
  return (negative ? -power : power) + (base == 16 ? 4 : 1) * places > 0;
}

std::string with_buffer(const auto& write) {
  // Length of the longest text: sign, point, exponent and 17 digits.
  std::array<char, 32> text{};
  return {text.data(), write(text.data(), text.data() + text.size()).ptr};
}

}  // namespace

std::string number_text(double value) {
  return with_buffer(
      [value](char* first, char* last) { return std::to_chars(first, last, value); });
}

std::array<std::string, 2> numbers_apart(double a, double b) {
  std::array<std::string, 2> texts = {format_number(a), format_number(b)};
  if (a != b && texts[0] == texts[1]) texts = {number_text(a), number_text(b)};
  return texts;
}

result<double> parse_number(std::string_view token) {
  const auto no_number = [token] {
    return error{quoted_token(token) + " is not a number", error_code::bad_number};
  };
  std::string_view digits = token;
  const bool negative = !digits.empty() && digits.front() == '-';
  if (!digits.empty() && (negative || digits.front() == '+')) digits.remove_prefix(1);
  const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
  if (hexadecimal) digits.remove_prefix(2);
  // Refuses a second sign, which from_chars would accept here.
  if (digits.empty() || digits.front() == '-' || digits.front() == '+') return no_number();

  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto read = read_double(digits.data(), end, value, hexadecimal);
  if (read.ec == std::errc::invalid_argument || read.ptr != end) return no_number();
  // Refuses "0xinf", which is not C99's; plain "inf" and "nan" are numbers, but not finite ones.
  if (hexadecimal && !std::isfinite(value)) return no_number();
  // Finds whether a number overflowed: from_chars does not distinguish overflow from underflow.
  if (read.ec == std::errc::result_out_of_range)
    value = is_huge(digits, hexadecimal ? 16 : 10) ? HUGE_VAL : 0;
  if (!std::isfinite(value))
    return error{quoted_token(token) + " is not finite", error_code::bad_number};
  return negative ? -value : value;
}

}  // namespace asterism::internal
