// SPDX-License-Identifier: MIT
//
// Reads a plane mesh from a VTK unstructured grid (.vtu).
//
// Triangles are cells of type 5, cells of type 3 lines: each is a segment. Regions and markers are
// the values that one array of cell data has for them: the first of those that programs name so
// (region, gmsh:physical, medit:ref and the like), else the only one of whole numbers, with a note.
// A file of ours has its boundary in the field data "boundary", and its metric in the point data
// "metric". Refused: other cells but points, a third coordinate other than 0, several arrays that
// could be the regions.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

struct vtu_mesh {
  mesh content;
  bool has_metric = false;  // else every vertex has the identity
};

// `file` is the file's name, for messages.
result<vtu_mesh> read_vtu_mesh(std::string_view text, const std::string& file);

}  // namespace asterism::internal
