// SPDX-License-Identifier: MIT
//
// Splits text files into words with line numbers, for the readers of this folder. Errors have the
// form `file:line: what`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

// Reads the whole file, without the byte order mark some editors put before UTF-8; fails naming it
// when it is missing, no regular file, or unreadable.
result<std::string> read_text_file(const std::filesystem::path& path);

// Returns the text with `?` for control characters: messages may contain parts of files, and a
// terminal would obey them.
std::string without_controls(std::string text);

struct word {
  std::string_view text;
  std::size_t line = 0;  // from 1

  bool empty() const { return text.empty(); }
};

// Words are separated by blanks (space, tab, return, form feed, line ends). A mark, `#` unless
// another is named, starts a comment that runs to the end of its line; the mark 0 none. The text
// must outlive the scanner and its words.
class text_scanner {
 public:
  text_scanner(std::string file, std::string_view text, char comment_mark = '#')
      : file_(std::move(file)), text_(text), comment_mark_(comment_mark) {}

  // Returns the next word, or an empty one (with the last line's number) at the end of the text.
  word next();
  // Returns the words of the next line that has any; empty at the end of the text.
  std::vector<word> next_line();
  // Returns the rest of the current line, without its end, and continues with the next line.
  std::string_view rest_of_line();
  // Returns the next `count` bytes of the text; fewer if the text ends before.
  std::string_view take_bytes(std::size_t count);
  // Returns the text from the next line on; nothing where words are left on this one.
  std::optional<std::string_view> next_lines() const;
  // Continues after the first `bytes` of next_lines(), which are `lines` lines.
  void pass_over(std::size_t bytes, std::size_t lines);
  // Writes the words of the next line to `words`, whose memory is used again for each line.
  void next_line(std::vector<word>& words);
  // Returns the comments read so far, without their `#`.
  const std::vector<std::string_view>& comments() const { return comments_; }

  std::size_t line() const { return line_; }
  // Returns the number of bytes not yet read: no more records than that can follow.
  std::size_t remaining() const { return text_.size() - position_; }
  const std::string& file() const { return file_; }
  // Returns the failure `file:line: what`.
  error failure(std::size_t line, const std::string& what,
                error_code code = error_code::malformed_file) const;

 private:
  void skip_blanks(bool across_lines);
  bool at_end() const { return position_ == text_.size(); }

  std::string file_;
  std::string_view text_;
  char comment_mark_;
  std::size_t position_ = 0, line_ = 1;
  std::vector<std::string_view> comments_;
};

// Returns the value of a word, or the error `file:line: <meaning>: ...`. Exponents may be
// Fortran's: 1.5D-3, 1.5d-3, and 1.5-103, which has no room for the letter.
result<double> to_number(const text_scanner& source, const word& w, std::string_view meaning);
// Reads x and y. `of` is a noun for messages: "vertex" for "x of vertex".
result<point> to_point(const text_scanner& source, const word& x, const word& y,
                       std::string_view of);
result<long long> to_integer(const text_scanner& source, const word& w, std::string_view meaning);
// Reads a marker or reference, an int.
result<int> to_marker(const text_scanner& source, const word& w, std::string_view meaning);
// Reads the number of records that follow: not negative, and no more than the rest of the file can
// hold when each takes at least two bytes.
result<std::size_t> to_count(const text_scanner& source, const word& w, std::string_view meaning);

}  // namespace asterism::internal
