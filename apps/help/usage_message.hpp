// SPDX-License-Identifier: MIT
//
// Writes messages about a command line that could not be parsed, with the probable correction.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace asterism::apps {

// Returns the message for a failure of the parser, with a line that names the help to read. `words`
// are the arguments without the program's own name.
std::string usage_message(const CLI::App& program, const std::vector<std::string>& words,
                          const CLI::ParseError& failure);

// Returns the message for a first word that is no command.
std::string no_such_command(const CLI::App& program, const std::string& word);

// Returns the message for a word like -hmax or -output, in which the parser would read a short
// option, -h or -o, and take the rest for its value; none where there is no such word. Words behind
// `challenge` are not examined: some belong to another program.
std::optional<std::string> misread_option(const CLI::App& program,
                                          const std::vector<std::string>& words);

// Returns the message for an empty word in the place of a file's name or a command; none where
// there is no such word, or behind `challenge`. Options have messages for their own values.
std::optional<std::string> empty_file_name(const std::vector<std::string>& words);

// Returns the message for a dash or a device that stands for standard input or output in place of a
// file; none where there is no such word, or where the command accepts it.
std::optional<std::string> misused_stream(const std::vector<std::string>& words);

}  // namespace asterism::apps
