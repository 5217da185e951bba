// SPDX-License-Identifier: MIT
//
// Converts doubles to and from text by the C library's functions: musl's are exact and have no
// locale.
#include "standard_library.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "shortest_text.hpp"

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
namespace {

bool is_digit(char c, bool hexadecimal) {
  const char lower = static_cast<char>(c | 0x20);
  return (c >= '0' && c <= '9') || (hexadecimal && lower >= 'a' && lower <= 'f');
}

const char* skip_digits(const char* at, const char* last, bool hexadecimal) {
  while (at != last && is_digit(*at, hexadecimal)) ++at;
  return at;
}

// Returns where "inf", "infinity" or "nan" at `at` ends; `at` if none is there.
const char* skip_word(const char* at, const char* last) {
  for (const char* word : {"infinity", "inf", "nan"}) {
    const std::size_t length = std::strlen(word);
    if (static_cast<std::size_t>(last - at) < length) continue;
    std::size_t same = 0;
    while (same < length && (at[same] | 0x20) == word[same]) ++same;
    if (same == length) return at + length;
  }
  return at;
}

// Returns where the number at `first` ends; `first` if there is none.
const char* end_of_number(const char* first, const char* last, bool hexadecimal) {
  const char* at = first != last && *first == '-' ? first + 1 : first;
  if (const char* const end = skip_word(at, last); end != at) return end;
  const char* const whole = skip_digits(at, last, hexadecimal);
  std::ptrdiff_t digits = whole - at;
  at = whole;
  if (at != last && *at == '.') {
    const char* const fraction = skip_digits(at + 1, last, hexadecimal);
    digits += fraction - (at + 1);
    at = fraction;
  }
  if (digits == 0) return first;
  if (at != last && (*at | 0x20) == (hexadecimal ? 'p' : 'e')) {
    const char* power = at + 1;
    if (power != last && (*power == '+' || *power == '-')) ++power;
    if (const char* const end = skip_digits(power, last, false); end != power) at = end;
  }
  return at;
}

}  // namespace

std::from_chars_result std::from_chars(const char* first, const char* last, double& value,
                                       chars_format format) {
  const bool hexadecimal = format == chars_format::hex;
  const char* const end = end_of_number(first, last, hexadecimal);
  if (end == first) return {first, errc::invalid_argument};
  string text(first, end);
  if (hexadecimal) text.insert(text.front() == '-' ? 1 : 0, "0x");
  errno = 0;
  const double read = strtod(text.c_str(), nullptr);
  // ERANGE is no failure for a subnormal number.
  if (errno == ERANGE && (read == 0 || isinf(read))) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc()};
}
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace {

std::to_chars_result copied(const std::string& text, char* first, char* last) {
  if (static_cast<std::size_t>(last - first) < text.size())
    return {last, std::errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), std::errc()};
}

}  // namespace

std::to_chars_result std::to_chars(char* first, char* last, double value) {
  return copied(asterism::internal::shortest_text(value), first, last);
}

std::to_chars_result std::to_chars(char* first, char* last, double value, chars_format format,
                                   int precision) {
  const char* const form = format == chars_format::scientific ? "%.*e"
                           : format == chars_format::fixed    ? "%.*f"
                                                              : "%.*g";
  asterism::internal::text_of_double text;
  snprintf(text.data(), text.size(), form, precision, value);
  return copied(text.data(), first, last);
}
#endif
