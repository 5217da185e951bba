// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/surface_input.hpp"

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/surface/built_in_surfaces.hpp"
#include "asterism/mesh/surface_io/surface_json.hpp"

namespace asterism::apps {
using namespace internal;

namespace {

bool is_of_cad_program(const std::string& name) {
  for (const char* ending : {".step", ".stp", ".brep", ".brp", ".iges", ".igs"})
    if (has_ending(name, ending)) return true;
  return false;
}

}  // namespace

result<surface> find_surface(const std::string& name) {
  if (auto known = built_in_surface(name)) return std::move(*known);
  if (is_of_cad_program(name))
    return error{"surface " + name +
                     ": files of CAD programs are not read here; their faces can be given as "
                     "B-spline patches with loops in a .json file",
                 error_code::bad_option};
  if (!has_ending(name, ".json")) {
    std::string names;
    for (const std::string& known : built_in_surface_names()) names += known + ", ";
    const bool is_mesh = has_ending(name, ".obj") || has_ending(name, ".stl") ||
                         has_ending(name, ".ply") || has_ending(name, ".mesh");
    return error{
        "surface " + name + ": " + names + "or a .json file of patches is wanted" +
            (is_mesh ? "; `asterism deviation MESH SURFACE` compares a mesh with one" : ""),
        error_code::bad_option};
  }
  return read_surface(name);
}

}  // namespace asterism::apps
