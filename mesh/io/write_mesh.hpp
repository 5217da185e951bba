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
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/draw/picture.hpp"
#include "asterism/mesh/draw/report.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism {

// The formats of meshes, pictures and pages.
enum class mesh_format {
  medit,
  vtu,
  svg,
  png,
  pdf,
  html,
  gmsh,
  gmsh2,
  su2,
  node,
  medit_binary,
  sms,
  adcirc
};

// Returns the format that the extension names, in upper or lower case; the error lists the known
// ones.
ASTERISM_EXPORT result<mesh_format> mesh_format_of(const std::filesystem::path& path);

// Checks that a mesh could be written there. Refuses unknown extensions, missing or unwritable
// directories, places taken by something that is not a regular file, and pictures where cairo is
// missing; for finding out before a long computation.
ASTERISM_EXPORT result<mesh_format> check_output(const std::filesystem::path& path);

// Returns every file that is written with `path`, itself first.
ASTERISM_EXPORT std::vector<std::filesystem::path> files_of_output(
    const std::filesystem::path& path);

// Options of writing.
struct write_options {
  picture_options picture;    // for .svg, .png and .pdf
  report_facts report = {};   // for .html
  physical_names names = {};  // for .msh, .su2 and .14
  // A sentence about the mesh for whoever opens the file: a comment in .mesh, .vtu and .svg.
  std::string note = {};
  // Given vertices, ascending, that are no corners though the boundary turns there: they divide a
  // curve. For .mesh and .meshb, which list corners and what must stay.
  std::vector<vertex_index> smooth = {};
  // False for a mesh whose metric says nothing, and is left out, as is what is measured by it.
  bool with_metric = true;
  // Fields on the mesh: node data of .msh and .vtu; in NAME.sol beside a .mesh, where there is no
  // metric, and else in NAME.fields.sol. Other formats have no place for them. Not owned.
  const solution* fields = nullptr;
};

// Writes the mesh. Returns the files written, in order.
ASTERISM_EXPORT result<std::vector<std::filesystem::path>> write_mesh(
    const std::filesystem::path& path, const mesh& m, const write_options& options = {});

}  // namespace asterism
