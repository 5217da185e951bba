// SPDX-License-Identifier: MIT
//
// Reads and writes Medit's ASCII formats: a mesh in NAME.mesh and its metric in NAME.sol.
//
// Written: MeshVersionFormatted 2 (doubles), Dimension 2, Vertices (reference: marker of the
// boundary there, 0 inside), Triangles (reference: the region), Edges (the boundary subsegments,
// domain on the left, and those of internal segments; reference: the marker), Corners (given
// vertices where the boundary turns), RequiredVertices (the given vertices); SolAtVertices, one
// symmetric tensor a vertex as `m11 m12 m22`. Numbers are the shortest texts with which the
// same doubles are read back. Medit has no place for the input segment a boundary subsegment
// belongs to: it is kept in comments (`#segments`, numbers from 1), which other programs skip.
//
// Read: versions 1 to 3, keywords in any order and any number to a line; comments; sections of
// known shape that mean nothing here, BAMG's among them, are skipped by their counts. Refused:
// three dimensions (except for files of Dimension 3 without volume elements, with a Z of 0
// everywhere), binary files, unknown sections, quadrilaterals, numbers that are not finite, indices
// out of range. Source: P. Frey, "MEDIT: an interactive mesh visualization software", INRIA
// RT-0253, 2001.
#pragma once

#include <filesystem>
#include <string>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/io/medit_read_options.hpp"

namespace asterism {

// Returns `NAME.mesh`, or the same in binary, `NAME.meshb` (mesh/io/medit_binary.hpp), with the
// tensors of `NAME.sol` beside it. Edges are a set, turned so that a triangle is on their left;
// those with triangles on both sides are internal where the file marks them as segments
// (mesh/io/medit_edges.hpp), and left out elsewhere. References of triangles that are all 1 mean no
// regions. `given` is the number of required vertices if these are the first ones, else
// 0. Subsegments without `#segments` comments are numbered each as its own segment. Tensors are
// checked to be positive definite, exactly. Nothing is assumed or checked about the geometry: the
// auditor does that.
ASTERISM_EXPORT result<mesh> read_medit(const std::filesystem::path& path,
                                        const medit_read_options& options = {});

// Returns the parts that the file requires: its Corners, RequiredVertices and RequiredEdges. Sites
// are numbered as read_medit numbers them.
ASTERISM_EXPORT result<mesh_marks> read_medit_marks(const std::filesystem::path& path);

// Returns the contents of the .mesh file; mesh/io/write_mesh.hpp writes both files.
ASTERISM_EXPORT std::string medit_mesh_text(const mesh& m);
// Returns the contents of the .sol file.
ASTERISM_EXPORT std::string medit_solution_text(const mesh& m);

// Returns NAME.sol for NAME.mesh, NAME.solb for NAME.meshb.
ASTERISM_EXPORT std::filesystem::path solution_path(const std::filesystem::path& mesh_path);

}  // namespace asterism
