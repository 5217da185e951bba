// SPDX-License-Identifier: MIT
//
// Says what is wrong with a command line that could not be parsed, and what was probably meant.
#pragma once

#include <optional>
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

// Returns the message for a word that is no command.
std::string no_such_command(const CLI::App& program, const std::string& word);

// Returns the message for a word like -hmax, in which the parser would read -h and forget the rest;
// none where there is no such word. Words behind `challenge` are left alone: some are another
// program's.
std::optional<std::string> misread_help(const CLI::App& program,
                                        const std::vector<std::string>& words);

// Returns the message for a dash or a device that stands for standard input or output where a file
// is wanted; none where there is no such word, or the command takes it.
std::optional<std::string> misused_stream(const std::vector<std::string>& words);

}  // namespace asterism::apps
