// SPDX-License-Identifier: MIT
//
// Colours words at a terminal, and nowhere else.
#pragma once

#include <string>

namespace asterism::apps {

enum class ink { red, green, yellow };

// Returns the text in bold and in colour if the stream (1: standard output, 2: standard error) is a
// terminal that has colours, and the environment has no NO_COLOR; else the text as it is.
// Source: https://no-color.org.
std::string in_colour(const std::string& text, ink colour, int stream);

}  // namespace asterism::apps
