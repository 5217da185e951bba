// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/other_kind.hpp"

#include <array>
#include <filesystem>
#include <system_error>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_kinds.hpp"

namespace asterism {
using internal::has_ending;
namespace {

struct known_kind {
  std::string_view ending, what;
};

constexpr std::string_view domain_text =
    "is a domain; a mesh of it is wanted, and `asterism mesh` makes one";
constexpr std::string_view space_text =
    "is a mesh in space, which `asterism deviation` and `asterism verify` take; a mesh of the "
    "plane, or a domain, is wanted";
constexpr std::string_view other_space_text =
    "is a mesh in space; of those .obj, .stl, .ply, .mesh, .msh and .vtu are read";
constexpr std::string_view values_text =
    "holds values at the vertices of a mesh; the file of the mesh itself is wanted";

constexpr std::string_view gmsh_text =
    "is a script of gmsh; 'gmsh -2 -format msh' makes a mesh of it, which is read";
constexpr std::string_view cad_text =
    "is a file of a CAD program; 'asterism-occt' makes a .json of .step and .brep for 'asterism "
    "surface', and a plane outline is read as .dxf by Python's asterism.read_dxf";
constexpr std::string_view drawing_text =
    "is a drawing; Python's asterism.poly_of_dxf makes a .poly of it";
constexpr std::string_view table_text =
    "may be a table of points; a .node file or Python's asterism.mesh(points) takes these";

constexpr std::array<known_kind, 19> other_kinds = {{{".obj", space_text},
                                                     {".ply", space_text},
                                                     {".off", other_space_text},
                                                     {".sol", values_text},
                                                     {".solb", values_text},
                                                     {".bb", values_text},
                                                     {".mtr", values_text},
                                                     {".certificate.json", "is a certificate"},
                                                     {".geo", gmsh_text},
                                                     {".geo_unrolled", gmsh_text},
                                                     {".step", cad_text},
                                                     {".stp", cad_text},
                                                     {".brep", cad_text},
                                                     {".brp", cad_text},
                                                     {".iges", cad_text},
                                                     {".igs", cad_text},
                                                     {".dxf", drawing_text},
                                                     {".csv", table_text},
                                                     {".txt", table_text}}};

}  // namespace

std::string what_it_is(std::string_view name) {
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored))
    return "; it is a directory, and a file is wanted";
  for (const known_kind& kind : other_kinds)
    if (has_ending(name, kind.ending)) return "; it " + std::string(kind.what);
  return internal::is_domain_name(name) ? "; it " + std::string(domain_text) : "";
}

}  // namespace asterism
