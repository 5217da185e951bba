// SPDX-License-Identifier: MIT
//
// Adds what the project uses of the standard library and Emscripten's lacks: the libc++ 13 of
// Emscripten 3.1.6 (Debian 12) has neither std::bit_cast nor any text of doubles in <charconv>.
// libc++ 14 brings the first and std::to_chars, libc++ 20 std::from_chars; from there on nothing of
// this is left. Included before every source (-include).
#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
#include <bit>
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& x) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, x);
}
}  // namespace std
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
#include <charconv>
#define ASTERISM_STANDARD_DOUBLES  // for core/double_reader.hpp
namespace std {
#if _LIBCPP_VERSION < 14000
// Writes the fewest digits that are read as `value` again, in fixed notation where it is not
// longer.
to_chars_result to_chars(char* first, char* last, double value);
// Writes as printf's %e, %f or %g does.
to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision);
#endif
// Reads the nearest double: of "general" texts, and of hexadecimal ones, which come without "0x".
from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format = chars_format::general);
}  // namespace std
#endif
