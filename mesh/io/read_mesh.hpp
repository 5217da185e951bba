// SPDX-License-Identifier: MIT
//
// Reads a mesh in the format that the extension names: .mesh and .meshb (mesh/io/medit.hpp), .msh
// (and .msh2) of gmsh and FreeFEM, .vtu and .vtk, .su2, ADCIRC's .14 and .grd, .2dm, .stl; anything
// else as Medit's .mesh.
//
// Whatever the format, the mesh is put in order, with a note for each kind of change: clockwise
// triangles are turned over, quadrilaterals split in two, vertices in no triangle left out, heights
// up to rounding dropped, sides that are not listed get the marker 0. Files whose order would
// change the domain are refused (docs/manual/files.md).
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/data/side_nodes.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/io/side_of_edge.hpp"

namespace asterism {

// Contents of a mesh's file.
struct mesh_file {
  mesh content;
  mesh_marks marks;
  physical_names names;
  // Vertices that were left out, by their numbers in the file from 0, ascending: files of values at
  // its vertices have entries for them, too.
  std::vector<vertex_index> left_out;
  bool has_metric = false;  // else every vertex has the identity
  // Parts inside a domain of edges alone, as BAMG's SubDomainFromGeom lists them; empty: all that
  // the edges enclose.
  std::vector<side_of_edge> parts = {};
  // Number of elements of second order, and nodes of their sides that differ from the middles,
  // ascending by the ends. `content` has a note that elements are taken by their corners.
  std::size_t second_order = 0;
  std::vector<side_node> curved = {};
};

// Removes the note that elements are taken by their corners alone: for callers that take their
// sides as well.
ASTERISM_EXPORT void take_back_note_of_corners(mesh_file& read);

// True if a file of this name is a mesh: .mesh, .meshb, .msh, .msh2, .vtu, .vtk, .su2, .14, .grd,
// .2dm or .stl. It may be one of edges alone, which are a domain.
ASTERISM_EXPORT bool is_mesh_file(std::string_view name);

// Returns the end of a message about a file that cannot be read as a mesh; empty for a mesh's name.
// It says what kind the name shows, or that the file was read as Medit's format although its name
// has no known ending.
ASTERISM_EXPORT std::string kind_hint(const std::filesystem::path& path);

// True if a file of this name has numbers at the vertices of a mesh that can be its metric: .sol,
// .solb or .mtr.
ASTERISM_EXPORT bool is_metric_file(std::string_view name);

// Reads a mesh with its metric. A .msh or .vtu file has its own metric, as data at its nodes; the
// options about a .sol then apply to that, and options.solution names another file. Other formats
// have none. A file of edges alone has no triangles and needs no metric.
ASTERISM_EXPORT result<mesh_file> read_mesh_file(const std::filesystem::path& path,
                                                 const medit_read_options& options = {});

// Reads a mesh as read_mesh_file does; returns the mesh alone, without the other contents of the
// file.
ASTERISM_EXPORT result<mesh> read_mesh(const std::filesystem::path& path,
                                       const medit_read_options& options = {});

// Returns the parts that the file requires to stay; only Medit's formats have such parts.
ASTERISM_EXPORT result<mesh_marks> read_mesh_marks(const std::filesystem::path& path);

// Returns the names that a file gives to markers and regions; a Medit file gives none, a .poly
// file to regions whose attributes are no whole numbers. Empty if the file cannot be read,
// too.
ASTERISM_EXPORT physical_names names_in(const std::filesystem::path& path);

}  // namespace asterism
