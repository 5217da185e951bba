// SPDX-License-Identifier: MIT
//
// Turns Medit's binary files, .meshb and .solb, into the words of its text files and back, so that
// one reader and one writer suffice for both.
//
// A file is a number 1 (which shows the order of bytes), a version, and sections: a keyword's
// number, the place in the file where the next section begins, a count, and the records. Reals have
// 4 bytes in version 1, else 8; integers 8 in version 4, else 4; places 8 from version 3 on, else
// 4. Both orders of bytes are read; written is version 2, little-endian, or 3 beyond 2 gigabytes.
// Sections that the reader of text does not use are skipped by their places. Source: libMeshb 7,
// https://github.com/LoicMarechal/libMeshb, whose format this is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// True for the names of binary files, .meshb and .solb.
bool is_medit_binary(const std::filesystem::path& path);

// Returns a Medit file as text, for text and binary files. Fails where it cannot be read, and where
// a binary one is cut off, has a count that its length cannot hold, or places that do not lead on;
// the message has the byte.
result<std::string> read_medit_text(const std::filesystem::path& path);

// Returns the text of a binary file.
result<std::string> text_of_medit_binary(const std::string& file, std::string_view bytes);

// Returns the binary form of a text that this library wrote. Adds a section RequiredEdges with
// these edges, counted from 1, if there are any: the text states in a comment that all edges are
// segments, and the binary form has no comments.
std::string medit_binary_of_text(const std::string& text,
                                 const std::vector<std::size_t>& required_edges = {});

}  // namespace asterism::internal
