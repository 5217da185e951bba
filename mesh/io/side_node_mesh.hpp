// SPDX-License-Identifier: MIT
//
// Converts a mesh to the form in which files have second-order triangles: a node for every side,
// numbered after the vertices.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism::internal {

// A mesh with nodes. Values at a node are the means of those at the ends of its side: the values of
// a linear field in the middle.
struct side_node_mesh {
  mesh content;  // its sites go on with the nodes
  // Nodes of the sides 01, 12, 20 of each triangle, then of each disagreeing triangle.
  std::vector<std::array<vertex_index, 3>> of_triangles;
  std::vector<vertex_index> of_edges;  // of each boundary edge
  solution fields;
};

// Adds the nodes, in the order of the ends of their sides. `fields` may be null.
side_node_mesh with_side_nodes(const mesh& m, const std::vector<side_node>& curved,
                               const solution* fields);

}  // namespace asterism::internal
