// SPDX-License-Identifier: MIT
//
// Writes Medit's ASCII formats (mesh/io/medit.hpp) piece by piece.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"

namespace asterism::internal {

// Given vertices, ascending, that are no corners since they divide a curve. If the file keeps
// comments, these vertices need not be listed in RequiredVertices either: a comment has the number
// of given vertices.
struct medit_smooth {
  std::vector<vertex_index> vertices = {};
  bool keeps_comments = true;
};

// Gives the contents of the .mesh file to the sink; its first line is in the first piece.
void write_medit_mesh(const mesh& m, const medit_smooth& smooth, const byte_sink& put);
// Gives the contents of the .sol file.
void write_medit_solution(const mesh& m, const byte_sink& put);

}  // namespace asterism::internal
