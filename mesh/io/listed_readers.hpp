// SPDX-License-Identifier: MIT
//
// Declares the readers of meshes, one for each format. Each lists the contents of its file and
// passes them to put_in_order; read_mesh chooses among them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"
#include "asterism/mesh/io/medit_read_options.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

// Reads Medit's .mesh or .meshb, with the metric that the options name.
result<listed_mesh> read_listed_medit(const std::filesystem::path& path,
                                      const medit_read_options& options);

// True if the file begins as FreeFEM's savemesh writes a .msh: with three counts.
bool is_freefem_mesh(text_scanner source);
// Reads FreeFEM's .msh: the numbers of vertices, triangles and edges, then each of them with a
// label.
result<listed_mesh> read_freefem(text_scanner& source);

// Reads the sections of gmsh's .msh and leaves them as they are listed: nodes may be in space,
// their third coordinates among the heights, and vertices may be in no triangle. Marks and regions
// are numbers of sets of groups.
result<listed_mesh> read_gmsh_as_listed(text_scanner& source);

// Reads SU2's .su2 of one zone: triangles and quadrilaterals, and the lines of the markers, whose
// tags are kept as names. Source: su2code.github.io, "Mesh File".
result<listed_mesh> read_su2(std::string_view text, const std::string& file);

// Reads ADCIRC's fort.14 (.14, .grd): triangles and quadrilaterals, and the sides along the strings
// of open and land boundaries, numbered in their order and named after their kind. Depths are no
// part of a plane mesh. Source: adcirc.org, "Grid and Boundary Information File (fort.14)".
result<listed_mesh> read_adcirc(std::string_view text, const std::string& file);

// Reads SMS's .2dm: elements, their first material as region, and the sides along node strings.
// Heights of nodes are the heights of a bed. Source: xmswiki.com, "2D Mesh Files *.2dm".
result<listed_mesh> read_sms(std::string_view text, const std::string& file);

// Reads a plane .stl, text or binary: corners at one place are one vertex; several solids are
// regions.
result<listed_mesh> read_stl(std::string_view text, const std::string& file);

// Reads VTK's older .vtk, text or binary, of an unstructured grid or of polygons. Source: "VTK File
// Formats", "Simple Legacy Formats".
result<listed_mesh> read_vtk(std::string_view text, const std::string& file);

}  // namespace asterism::internal
