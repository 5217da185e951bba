// SPDX-License-Identifier: MIT
//
// Holds a mesh as its file lists it, and puts it in order: one step for the readers of all
// formats.
//
// Changed, with a note each: heights up to rounding and one height for all are left out;
// quadrilaterals are split in two; elements of higher order keep their corners alone; clockwise
// triangles are turned over; a triangle or an edge that is listed again is left out; and so are
// vertices in no triangle, with the edges at them. Nodes of sides are kept aside. Refused, naming
// file and line: vertices out of the plane, quadrilaterals that no diagonal splits, one triangle in
// two regions, one edge with two markers. A list without triangles stays as it is: its edges may be
// a domain.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/data/side_nodes.hpp"
#include "asterism/mesh/io/physical_names.hpp"
#include "asterism/mesh/io/side_of_edge.hpp"
#include "asterism/mesh/io/wide_references.hpp"

namespace asterism::internal {

// Largest height, as a part of the extent, that counts as rounding of programs that turn a plane.
inline constexpr double rounding_of_heights = 1e-9;

// A third coordinate that is not 0, and its vertex.
struct listed_height {
  vertex_index vertex;
  std::size_t line;
  double z;
};

struct listed_quadrilateral {
  std::array<vertex_index, 4> corners;
  int region;
  std::size_t line;
};

// A side of an element of second order with its node, as listed in the file.
struct listed_side {
  vertex_index a, b, node;
};

struct listed_mesh {
  std::string file;
  // Triangles, and edges in either direction. Regions: one for each triangle, or an empty list.
  mesh content;
  std::vector<listed_height> heights;
  std::vector<listed_quadrilateral> quadrilaterals;
  std::size_t second_order = 0;  // elements of which the corners alone were taken
  std::vector<listed_side> sides;
  // Nodes of sides that differ from the middles, ascending by their ends; found by put_in_order.
  std::vector<side_node> curved;
  // Edges that the file requires, by their indices in content.boundary.
  std::vector<std::size_t> required_edges;
  bool all_edges = false;          // every edge listed is a segment
  bool lists_sides = false;        // sides that are not listed were taken away
  bool edges_are_strings = false;  // lists of vertices for solvers, which need not follow sides
  mesh_marks marks;                // numbered as listed
  physical_names names;
  wide_references wide;
  bool has_metric = false;  // else every vertex has the identity
  // Vertices that were left out, by their numbers in the file from 0, ascending: files of values
  // have entries for them.
  std::vector<vertex_index> left_out;
  std::vector<side_of_edge> parts;  // of a domain of edges alone
};

enum class listed_order {
  put_right,  // for use
  as_listed,  // triangles and vertices as in the file: for a mesh that is judged as its file has it
};

// Returns the note on elements of higher order; readers of their sides as well remove it.
std::string note_of_higher_order(std::size_t elements);

// Puts the mesh in order.
std::optional<error> put_in_order(listed_mesh& m, listed_order how);

}  // namespace asterism::internal
