// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/mesh_format.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/medit.hpp"

namespace asterism {
using namespace internal;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, mesh_format>, 14> written_formats = {
    {{".mesh", mesh_format::medit},
     {".meshb", mesh_format::medit_binary},
     {".vtu", mesh_format::vtu},
     {".svg", mesh_format::svg},
     {".png", mesh_format::png},
     {".pdf", mesh_format::pdf},
     {".html", mesh_format::html},
     {".msh", mesh_format::gmsh},
     {".msh2", mesh_format::gmsh2},
     {".su2", mesh_format::su2},
     {".node", mesh_format::node},
     {".2dm", mesh_format::sms},
     {".14", mesh_format::adcirc},
     {".grd", mesh_format::adcirc}}};

std::string lower(std::string text) {
  for (char& c : text) c = lower_case(c);
  return text;
}

fs::path beside(const fs::path& path, const char* extension) {
  return fs::path(path).replace_extension(extension);
}

}  // namespace

bool is_picture(mesh_format format) {
  return format == mesh_format::svg || format == mesh_format::png || format == mesh_format::pdf;
}

result<mesh_format> mesh_format_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  for (const auto& [name, format] : written_formats)
    if (extension == name) return format;
  return error{path.string() + ": unknown kind of file '" + extension +
                   "'; there are .mesh, .meshb, .msh, .msh2, .vtu, .su2, .node, .2dm, .14, .grd, "
                   ".svg, .png, .pdf and "
                   ".html",
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
  auto format = mesh_format_of(path);
  if (!format.ok()) return format;
  if (is_picture(format.value()))
    if (const auto missing = missing_for_pictures()) return missing->at(path.string());
  for (const fs::path& file : files_of_output(path))
    if (const auto writable = check_writable(file); !writable.ok()) return writable.failure();
  return format;
}

bool holds_second_order(mesh_format format) {
  return format == mesh_format::gmsh || format == mesh_format::gmsh2 || format == mesh_format::vtu;
}

}  // namespace asterism
