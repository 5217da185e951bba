// SPDX-License-Identifier: MIT
//
// Writes Medit's ASCII formats (mesh/io/medit.hpp) piece by piece.
#pragma once

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"

namespace asterism::internal {

// Gives the contents of the .mesh file to the sink; its first line is in the first piece.
void write_medit_mesh(const mesh& m, const byte_sink& put);
// Gives the contents of the .sol file.
void write_medit_solution(const mesh& m, const byte_sink& put);

}  // namespace asterism::internal
