// SPDX-License-Identifier: MIT
//
// Writes a mesh in the format that the extension names.
//
//   .mesh              Medit, and the metric in .sol beside it (mesh/io/medit.hpp)
//   .meshb             the same in binary, and the metric in .solb
//   .vtu               VTK unstructured grid for ParaView (mesh/io/vtu.hpp)
//   .msh  .msh2        gmsh 4.1 and 2.2, with the metric (mesh/io/gmsh.hpp)
//   .su2               SU2 (mesh/io/plain_meshes.hpp)
//   .node              Triangle, with .ele and .edge beside it (mesh/io/plain_meshes.hpp)
//   .2dm               SMS (mesh/io/flow_meshes.hpp)
//   .14  .grd          ADCIRC's fort.14 (mesh/io/flow_meshes.hpp)
//   .svg  .png  .pdf   a picture (mesh/draw/picture.hpp)
//   .html              a page about the mesh (mesh/draw/report.hpp)
//
// A file appears complete or not at all: it is written under a temporary name beside its place and
// renamed. The bytes depend on the mesh and the options alone.
#pragma once

#include <filesystem>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/mesh_format.hpp"
#include "asterism/mesh/io/write_options.hpp"

namespace asterism {

// Checks that a mesh could be written there. Refuses unknown extensions, missing or unwritable
// directories, places taken by something that is not a regular file, and pictures if cairo is
// missing. Called before a long computation.
ASTERISM_EXPORT result<mesh_format> check_output(const std::filesystem::path& path);

// Writes the mesh. Returns the files written, in order.
ASTERISM_EXPORT result<std::vector<std::filesystem::path>> write_mesh(
    const std::filesystem::path& path, const mesh& m, const write_options& options = {});

}  // namespace asterism
