// SPDX-License-Identifier: MIT
//
// Says what is wrong with a command line that could not be parsed, and what was probably meant.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace asterism::apps {

// Returns the message, with a line that names the help to ask for. `words` are the arguments
// without the program's own name.
std::string usage_message(const CLI::App& program, const std::vector<std::string>& words,
                          const CLI::ParseError& failure);

}  // namespace asterism::apps
