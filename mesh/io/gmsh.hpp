// SPDX-License-Identifier: MIT
//
// Reads and writes gmsh's ASCII formats, .msh 4.1 and 2.2.
//
// Written: the vertices with the tags 1, 2, ...; one surface a region, one curve a marker, each
// with a physical group of that number and its name; a point element for each given vertex; the
// triangles, of second order (types 9 and 8) with nodes for their sides after the vertices, if they
// are given; the boundary subsegments as lines, domain on the left, internal ones too; and the
// metric as node data "metric", nine components. Numbers are the shortest texts that read back. The
// number of a physical group must be positive: a number of 0 or below takes a free one, and its
// own is in the group's name, "marker -7", from which it is read back.
//
// Read: versions 1, 2.0 to 2.2, 4.0 and 4.1; sections in the order that gmsh writes, tags in any
// order and with gaps; points, lines, triangles and quadrilaterals, of higher order by their
// corners; node data "metric"; other sections are skipped. Each line is a segment. An element in
// several physical groups has a number for the set of them and all their names. A file that does
// not begin like gmsh's is read as FreeFEM's (mesh/io/freefem_reader.cpp). Refused: binary files,
// elements of other kinds, tags that do not exist or twice, numbers that are not finite, and what
// put_in_order refuses. Source: the gmsh 4.11 manual, "MSH file format", and "MSH file format
// version 1/2 (Legacy)".
#pragma once

#include <filesystem>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/io/side_node_mesh.hpp"

namespace asterism::internal {

// Reads a file. Where no triangle is in a physical group, the regions are empty. Sets `given` to
// the number of the file's point elements if these are the first vertices, in order, else to 0.
// Tensors are checked to be positive definite, exactly.
result<listed_mesh> read_gmsh(const std::filesystem::path& path);

enum class gmsh_version { two, four };

// Contents of a file in addition to its mesh.
struct gmsh_contents {
  physical_names names = {};
  bool with_metric = true;
  const solution* fields = nullptr;  // node data; none, or not owned
  // Nodes of second-order triangles and lines; null for straight sides. Not owned; the mesh is its
  // content.
  const side_node_mesh* nodes = nullptr;
};

// Returns the contents of the file.
std::string gmsh_text(const mesh& m, const gmsh_contents& more, gmsh_version version);

}  // namespace asterism::internal
