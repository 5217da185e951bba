// SPDX-License-Identifier: MIT
//
// Makes text from files, names and arguments safe to show to people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asterism::internal {

// Returns the number of bytes of the first character of a text of UTF-8 that is not empty; 1 where
// the first byte begins no character.
std::size_t first_character_bytes(std::string_view text);

// Returns the text with `?` for each character that a terminal obeys or that breaks or reorders a
// line: controls and delete (of ASCII, and U+0080 to U+009F), separators of lines and paragraphs,
// marks of direction. A byte that is no UTF-8 stays, unless a terminal of eight bits obeys it.
std::string printable(std::string_view text);

// Returns the text as printable() does, with its long words cut: of a word of more than 240 bytes
// the first 100 and the last 60 stay, and an ellipsis between them. Names of files are rarely
// longer, and their two ends usually identify them.
std::string one_line(std::string_view text);

}  // namespace asterism::internal
