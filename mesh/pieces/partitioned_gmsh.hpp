// SPDX-License-Identifier: MIT
//
// Makes one partitioned file of gmsh's format 4.1 of the pieces of a mesh.
//
// Partition p is piece p. A vertex on a seam is written once, in the entity of the least piece that
// has it, and so is an edge of a seam, whose curve is in both partitions. Tags are 1, 2, ... in the
// order of pieces. Physical groups are those of mesh/io/gmsh.hpp; the marker of cuts is one of
// these. The metric is left out: the files of the pieces have it.
#pragma once

#include <functional>
#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/pieces/pieces_index.hpp"

namespace asterism::internal {

// Function that returns the mesh of a piece.
using piece_reader = std::function<result<mesh>(piece_index)>;

// Gives the file to the sink. Each piece is read twice, and one is held at a time. Fails if a piece
// cannot be read or is not the index's; the output is then invalid.
std::optional<error> write_partitioned_gmsh(const pieces_index& index, const physical_names& names,
                                            const piece_reader& read, const byte_sink& put);

}  // namespace asterism::internal
