// SPDX-License-Identifier: MIT
//
// Reads a mesh in the format that the extension names: .mesh and .meshb (mesh/io/medit.hpp), .msh
// (and .msh2) of gmsh and FreeFEM, .vtu and .vtk, .su2, ADCIRC's .14 and .grd, .2dm, .stl; anything
// else as Medit's .mesh.
//
// Whatever the format, the mesh is put in order, with a note for each kind of change: clockwise
// triangles are turned over, quadrilaterals split in two, vertices in no triangle left out, heights
// up to rounding dropped, sides that are not listed get the marker 0. What would change the domain
// is refused (docs/manual/files.md).
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

// What a file of a mesh has.
struct mesh_file {
  mesh content;
  mesh_marks marks;
  physical_names names;
  // Vertices that were left out, by their numbers in the file from 0, ascending: files of values at
  // its vertices have numbers for them, too.
  std::vector<vertex_index> left_out;
  bool has_metric = false;  // else every vertex has the identity
  // The parts of a domain of edges alone that are inside, as BAMG's SubDomainFromGeom has them;
  // empty: all that the edges enclose.
  std::vector<side_of_edge> parts = {};
  // Elements of second order, and the nodes of their sides that are not the middles, ascending by
  // the ends. `content` has a note that they are taken by their corners.
  std::size_t second_order = 0;
  std::vector<side_node> curved = {};
};

// Takes the note of a file back that its elements are taken by their corners alone: for whoever
// takes their sides, too.
ASTERISM_EXPORT void take_back_note_of_corners(mesh_file& read);

// True if a file of this name is a mesh: .mesh, .meshb, .msh, .msh2, .vtu, .vtk, .su2, .14, .grd,
// .2dm or .stl. It may be one of edges alone, which are a domain.
ASTERISM_EXPORT bool is_mesh_file(std::string_view name);

// True if a file of this name has numbers for the vertices of a mesh that can be its metric: .sol,
// .solb or .mtr.
ASTERISM_EXPORT bool is_metric_file(std::string_view name);

// Reads a mesh with its metric. A .msh or .vtu file has its own, as data at its nodes; the options
// about a .sol mean that for it, and options.solution names another. Other formats have none. A
// file of edges alone has no triangles and needs no metric.
ASTERISM_EXPORT result<mesh_file> read_mesh_file(const std::filesystem::path& path,
                                                 const medit_read_options& options = {});

// Returns the content of read_mesh_file.
ASTERISM_EXPORT result<mesh> read_mesh(const std::filesystem::path& path,
                                       const medit_read_options& options = {});

// Returns what the file says must stay. Formats other than Medit's say nothing of it.
ASTERISM_EXPORT result<mesh_marks> read_mesh_marks(const std::filesystem::path& path);

// Returns the names that a file gives to markers and regions; a Medit file gives none, a .poly file
// to regions whose attributes are no whole numbers. Empty, too,
// where the file cannot be read.
ASTERISM_EXPORT physical_names names_in(const std::filesystem::path& path);

}  // namespace asterism
