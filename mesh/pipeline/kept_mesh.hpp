// SPDX-License-Identifier: MIT
//
// Judges whether a mesh meets its metric as well as a new one would, and may stay.
#pragma once

#include <optional>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Numbers of vertices of a mesh with unit edges.
struct unit_counts {
  double inside;  // as the area alone has it
  double all;     // with the boundary
};

// Returns the numbers of vertices of a mesh of the same domain with edges of length one in the
// metric.
unit_counts vertices_of_unit_edges(const mesh& m);

// True if the mesh has the named number of vertices, to 2 %, or, if none was named, the number that
// its metric asks for, to a tenth.
bool has_enough_vertices(const mesh& m, const mesh_options& options);

// Lengths of the edges of a mesh, each the logarithmic mean of the lengths in the metrics of its
// ends.
struct edge_lengths {
  double unit_share = 0;  // from 1 / sqrt 2 to sqrt 2
  double least = 0, greatest = 0;
};

// Measures the edges of the mesh.
edge_lengths edge_lengths_of(const mesh& m);

// True if 95 edges of a hundred have lengths near one, and none is below a third or above 1.75, as
// in nearly all new meshes by the metric they are delivered in. In meshes for functions with fronts
// and layers, 97 to 99 of a hundred are near one, the least from 0.39 and the greatest up to 1.65
// (docs/results/adaptation.md).
bool are_as_in_new_mesh(const edge_lengths& lengths);

// True if the share of lengths near one is that of the new mesh, to 2 %, and no length is both
// outside [1/3, 1.75] and a quarter beyond the range of the new mesh's lengths. Where the domain
// has vertices nearer to each other than the metric wants, or the metric jumps, no mesh has better
// lengths.
bool are_no_worse(const edge_lengths& lengths, const edge_lengths& of_new);

// Returns the outcome that keeps the mesh of this domain as it is, where the auditor certifies
// it.
std::optional<mesh_outcome> outcome_of_keeping(const mesh& m, const domain& shape,
                                               const mesh_options& options);

}  // namespace asterism::internal
