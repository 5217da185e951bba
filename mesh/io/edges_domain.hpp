// SPDX-License-Identifier: MIT
//
// Makes a domain from the edges of a mesh file without triangles.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

namespace asterism::internal {

// True if the file lists edges and no triangle, as BAMG's geometries and the input of mmg2d do.
bool has_edges_alone(const mesh_file& file);

// Returns the domain that the edges bound, with their markers, by the rules for segments of a .poly
// file: vertices on no edge belong to it if they are inside. `name` is the file's. Notes are those
// of the file's reader. Where the file names parts that edges enclose, these parts have the file's
// numbers, and the others are holes.
result<domain> domain_of_edges(mesh_file file, const std::string& name);

}  // namespace asterism::internal
