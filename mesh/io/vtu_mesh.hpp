// SPDX-License-Identifier: MIT
//
// Reads a plane mesh from a VTK unstructured grid (.vtu).
//
// vtk_cells.hpp defines which cells are triangles, quadrilaterals and segments, and which array
// numbers the regions and markers. A file of this library has its boundary in the field data
// "boundary", and its metric in the point data "metric".
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"

namespace asterism::internal {

// `file` is the file's name, for messages.
result<listed_mesh> read_vtu_mesh(std::string_view text, const std::string& file);

}  // namespace asterism::internal
