// SPDX-License-Identifier: MIT
//
// Lays out the text of --help and `asterism help`.
#pragma once

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace asterism::apps {

// Groups the options of every command under headings: mesh wanted, domain, files and words, limits.
// An option that has no heading of its own stays under "Options".
void group_options(CLI::App& program);

// Returns the number of columns of a line: that of COLUMNS, else of the terminal that standard
// output is, else 100.
std::size_t help_columns();

// Returns the help with lines longer than `columns` broken between words. Continuation lines of a
// description are indented to its first word. Examples stay as they are: a broken command line
// cannot be copied.
std::string wrapped(const std::string& help, std::size_t columns);

}  // namespace asterism::apps
