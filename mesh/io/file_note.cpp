// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/file_note.hpp"

namespace asterism::internal {

// Replaces two hyphens in a row, which a comment in XML must not have.
std::string with_file_note(std::string contents, mesh_format format, const std::string& note) {
  if (note.empty()) return contents;
  std::string line;
  for (const char c : note) {
    if (c == '-' && !line.empty() && line.back() == '-') line += ' ';
    line += c == '\n' || c == '\r' ? ' ' : c;
  }
  line = format == mesh_format::medit ? "# " + line + "\n" : "<!-- " + line + " -->\n";
  return contents.insert(contents.find('\n') + 1, line);
}

}  // namespace asterism::internal
