// SPDX-License-Identifier: MIT
//
// Reads files. Separate from the scanner, so that a build without files can replace it by texts.
#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>

#include "asterism/mesh/io/similar_file.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

result<std::string> read_text_file(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status))
    return error{path.string() + ": no such file" + similar_file(path),
                 error_code::unreadable_file};
  // Accepts regular files only: a directory opens like a file and fails later, and a pipe may never
  // end.
  if (!std::filesystem::is_regular_file(path, status))
    return error{path.string() + ": not a regular file", error_code::unreadable_file};
  std::ifstream in(path, std::ios::binary);
  if (!in)
    return error{path.string() + ": cannot be opened for reading", error_code::unreadable_file};
  std::string text;
  // Reads until the end, since the size that a system states may be less than the contents. The
  // first part is one byte longer than that size, so that it is the only one where it is right.
  constexpr std::size_t least = 1 << 16;
  const std::uintmax_t stated = std::filesystem::file_size(path, status);
  std::size_t part = status || stated == 0 ? least : static_cast<std::size_t>(stated) + 1;
  while (in) {
    const std::size_t before = text.size();
    resize_in_threads(text, before + part);
    in.read(text.data() + before, static_cast<std::streamsize>(part));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
    part = least;
  }
  if (in.bad())
    return error{path.string() + ": cannot be read to its end", error_code::unreadable_file};
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

}  // namespace asterism::internal
