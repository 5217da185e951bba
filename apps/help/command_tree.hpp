// SPDX-License-Identifier: MIT
//
// Reads the commands and their options out of the parser, so that completions and manual pages list
// exactly what the program accepts.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace asterism::apps {

// An option, or a positional argument.
struct option_entry {
  std::vector<std::string> names;            // "-o", "--output"; of a positional its name alone
  std::string value;                         // "FILE"; empty: takes none
  std::vector<std::string> choices;          // all values there are, where they are a list
  std::vector<std::string> names_of_values;  // values that have a name; there are others
  std::string text;
  bool positional = false, required = false, repeats = false;
};

// A command, or the program itself.
struct command_entry {
  std::string name, text, footer;
  std::vector<option_entry> options;
};

// Returns the program, then its commands in their order.
std::vector<command_entry> command_tree(const CLI::App& program);

}  // namespace asterism::apps
