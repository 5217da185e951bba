// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/mesh_format.hpp"

#include <string>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/medit.hpp"

namespace asterism {
using namespace internal;
namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
  for (char& c : text) c = lower_case(c);
  return text;
}

fs::path beside(const fs::path& path, const char* extension) {
  return fs::path(path).replace_extension(extension);
}

}  // namespace

bool is_picture(mesh_format format) { return is_drawing(format) && format != mesh_format::html; }

result<mesh_format> mesh_format_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  for (const file_kind& kind : file_kinds())
    if (kind.format && extension == kind.ending) return *kind.format;
  return error{path.string() + ": unknown kind of file '" + extension + "'; there are " +
                   endings_of(is_written_kind, "and"),
               error_code::bad_option};
}

std::vector<fs::path> files_of_output(const fs::path& path) {
  const auto format = mesh_format_of(path);
  if (format &&
      (format.value() == mesh_format::medit || format.value() == mesh_format::medit_binary))
    return {path, solution_path(path)};
  if (format && format.value() == mesh_format::node)
    return {path, beside(path, ".ele"), beside(path, ".edge")};
  return {path};
}

bool holds_second_order(mesh_format format) { return kept_in(format).second_order; }

}  // namespace asterism
