// SPDX-License-Identifier: MIT
//
// Reads and writes solutions: numbers at the vertices of a mesh.
//
//   .sol   Medit: SolAtVertices with any list of types (1 scalar, 2 vector, 3 symmetric tensor);
//          the fields are called 1, 2, ... in their order
//   .solb  the same in binary (mesh/io/medit_binary.hpp)
//   .bb    BAMG: `2 N V 2`, then N scalars for each of V vertices; .BB: `2 N T1 ... TN V 2`, with
//          types 1 to 3
//   .msh   gmsh: the node data of 1, 3 or 9 numbers a node, by their names, except the metric
//   .vtu   VTK: the point data of one piece, as text, base64 or raw bytes, not compressed, by
//          their names
//
// Refused, with file, line and vertex: numbers that are not finite, counts that are not the mesh's,
// types and shapes that are none of these, anything after the last number.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism {

// Reads the solution on `m`, whose vertices it must have, in their order. Of a .vtu, arrays of
// floating-point numbers with 1, 2 or 3 components are read, the third being 0, and with 9 that are
// a symmetric tensor of the plane; its points must be those of `m` to six digits. A file with a
// single tensor field is a metric, and is refused.
ASTERISM_EXPORT result<solution> read_solution(const std::filesystem::path& path, const mesh& m);

// Reads the solution on a mesh of whose file some vertices were left out (read_mesh_file), by their
// numbers there, ascending: their values are left out, too.
ASTERISM_EXPORT result<solution> read_solution(const std::filesystem::path& path, const mesh& m,
                                               const std::vector<vertex_index>& left_out);

// Returns the scalars named: `NAME`, all components of it, or NAME.x, NAME.y. Without names: all
// scalars and vectors. They are sorted by name, each once. Fails for names that do not exist, for
// tensors, and if no field is left.
ASTERISM_EXPORT result<std::vector<nodal_values>> select_values(
    const solution& from, const std::vector<std::string>& names);

// Returns the contents of a .sol file, with the list of types.
ASTERISM_EXPORT std::string medit_fields_text(const solution& s);
// Returns the contents of a .bb file: all components as scalars.
ASTERISM_EXPORT std::string bamg_fields_text(const solution& s);

// Writes the solution in the format that the extension names, .sol, .solb or .bb.
ASTERISM_EXPORT result<std::filesystem::path> write_solution(const std::filesystem::path& path,
                                                             const solution& s);

}  // namespace asterism
