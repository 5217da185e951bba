// SPDX-License-Identifier: MIT
//
// Reads and writes doubles as text, correctly rounded and independent of the locale.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// Returns the double nearest to all of `token` (ties to even): decimal, or hexadecimal as in C99
// (0x1.8p-3), with an optional sign. Too small for a double is the nearest subnormal number or a
// zero of the same sign. Fails, quoting the token, if it is no number or not finite.
result<double> parse_number(std::string_view token);

// Returns the token in quotes, fit for one line of a message whatever it holds: cut when long,
// anything but printable ASCII shown as '?'.
std::string quoted_token(std::string_view token);

// Returns the shortest decimal that parse_number reads back as the same double.
std::string number_text(double value);

// Returns the number with six significant digits, as printf's %.6g in the C locale: for messages.
std::string format_number(double value);

// Returns the two numbers with six significant digits; with as many as the doubles need where two
// that differ would look alike.
std::array<std::string, 2> numbers_apart(double a, double b);

}  // namespace asterism::internal
