// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/mesh_format.hpp"

#include <string>
#include <system_error>

#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/render_mesh.hpp"

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

result<mesh_format> check_output(const std::filesystem::path& path) {
  auto format = check_place_of_output(path);
  if (!format.ok()) return format;
  if (const auto failed = check_all_writable(files_of_output(path))) return *failed;
  return format;
}

result<mesh_format> internal::check_place_of_output(const std::filesystem::path& path) {
  auto format = mesh_format_of(path);
  std::error_code ignored;
  if (!format.ok() && fs::is_directory(path, ignored))
    return error{path.string() + ": is a directory; a file in it is wanted, as " +
                     (path / "NAME.mesh").string(),
                 error_code::bad_option};
  if (!format.ok()) return format;
  if (is_picture(format.value()))
    if (const auto missing = missing_for_pictures()) return missing->at(path.string());
  for (const fs::path& file : files_of_output(path))
    if (const auto failed = check_place(place_of(file))) return *failed;
  return format;
}

bool holds_second_order(mesh_format format) { return kept_in(format).second_order; }

}  // namespace asterism
