// SPDX-License-Identifier: MIT
//
// Reads doubles from characters as std::from_chars does. Where the standard library has none for
// doubles (libc++ before 20), decimal numbers are read by fast_float, a header alone, and
// hexadecimal ones here. ASTERISM_FAST_FLOAT selects fast_float with any library.
#pragma once

#include <charconv>
#include <system_error>
#include <version>

#if defined(ASTERISM_STANDARD_DOUBLES)  // packages/npm/standard_library.hpp has them
#elif defined(__cpp_lib_to_chars) && !defined(ASTERISM_FAST_FLOAT)
#define ASTERISM_STANDARD_DOUBLES
#elif __has_include(<fast_float/fast_float.h>)
#include <fast_float/fast_float.h>

#include "asterism/core/hexadecimal_reader.hpp"
#else
#error "std::from_chars reads no doubles here: install fast_float (Debian: libfast-float-dev)"
#endif

namespace asterism::internal {

// Sets `value` to the nearest double, ties to even, of the longest beginning of the characters that
// is a number: decimal, or hexadecimal without the leading 0x. Returns the end of this beginning,
// and fails, as std::from_chars does. A decimal number that is too large or too small for a double
// may be infinite or zero instead of a failure.
inline std::from_chars_result read_double(const char* first, const char* last, double& value,
                                          bool is_hexadecimal) {
#ifdef ASTERISM_STANDARD_DOUBLES
  return std::from_chars(first, last, value,
                         is_hexadecimal ? std::chars_format::hex : std::chars_format::general);
#else
  if (is_hexadecimal) return read_hexadecimal(first, last, value);
  const auto read = fast_float::from_chars(first, last, value);
  return {read.ptr, read.ec};
#endif
}

}  // namespace asterism::internal
