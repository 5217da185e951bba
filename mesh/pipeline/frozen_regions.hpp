// SPDX-License-Identifier: MIT
//
// Adapts a mesh except for the triangles of some of its regions, which stay as they are.
//
// The other regions are adapted, certified and verified as a mesh of their own, called the rest:
// the border with the frozen regions is a part of its boundary, of which every vertex stays. The
// file has both parts together: first the vertices, triangles and edges of the rest, then those of
// the frozen regions.
//
// A mesher splits edges of a boundary for the metric or for stars, but edges of the border must
// not be split. So the tensors at its vertices are made coarser, by equal factors in all
// directions, until the mesh does not split them; `border_lengths` lists the lengths that are
// tried, in order.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"

namespace asterism {

// Greatest metric lengths of the border's edges that are tried in order, in the metrics of their
// ends.
inline constexpr std::array<double, 4> border_lengths = {0.9, 0.6, 0.4, 0.25};

// The mesh without the triangles of some regions, and its border with these.
struct frozen_part {
  mesh rest;
  // Number in the whole mesh of each vertex of the part that is not frozen.
  std::vector<vertex_index> vertex_of;
  // Border edges between the rest and the frozen triangles, with the rest on the left, by the
  // rest's numbers.
  std::vector<std::array<vertex_index, 2>> border;
  std::vector<vertex_index> shared;  // vertices of both, in the rest's numbers
  std::vector<vertex_index> frozen;  // triangles of the whole mesh that stay, ascending
  std::size_t lone_vertices = 0;     // of the frozen regions alone
};

// Divides a triangulation into the frozen triangles and the rest. Requires that edges between
// regions are boundary edges, as adopt_mesh leaves them. Fails where a region has no triangle, or
// no triangle is left.
ASTERISM_EXPORT result<frozen_part> without_regions(const mesh& whole,
                                                    const std::vector<int>& frozen);

// Makes the tensors at the ends of the border's edges coarser where they measure one of these edges
// as longer than `longest`. Returns the number of vertices changed.
ASTERISM_EXPORT std::size_t coarsen_border(frozen_part& part, double longest);

// Returns the marks of part.rest by its own vertex numbers, and marks the vertices and edges of the
// border as required. `marks` has the vertex numbers of the whole mesh.
ASTERISM_EXPORT mesh_marks marks_of_rest(const frozen_part& part, const mesh_marks& marks);

// Joins the frozen triangles to a mesh of the other regions. Returns nothing where an edge of the
// border is split, or a vertex of it is missing; `split` counts such edges.
ASTERISM_EXPORT std::optional<mesh> with_frozen(const mesh& made, const frozen_part& part,
                                                const mesh& whole, std::size_t& split);

// Least angles of the frozen triangles, in degrees, as any of their corners measures them.
struct frozen_angles {
  double worst = 180;
  std::size_t low = 0;  // triangles below the bound
};

// Returns the least angle of the frozen triangles, and how many are below the bound, in degrees.
ASTERISM_EXPORT frozen_angles angles_of_frozen(const frozen_part& part, const mesh& whole,
                                               double bound);

// Removes the triangles of the regions from a mesh that with_frozen made. Returns the mesh of the
// rest that it was made of, bit for bit. Fails where the rest's vertices are not the first ones.
ASTERISM_EXPORT result<mesh> rest_of(mesh together, const std::vector<int>& frozen);

// Returns a sentence on how the triangles of the regions in one mesh differ from those in another:
// each has to be there with the same corners, bit for bit, and no other. Empty if they are equal.
ASTERISM_EXPORT std::string difference_of_frozen(const mesh& together, const mesh& before,
                                                 const std::vector<int>& frozen);

}  // namespace asterism
