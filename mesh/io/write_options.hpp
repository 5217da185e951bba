// SPDX-License-Identifier: MIT
//
// Holds the options of writing a mesh.
#pragma once

#include <string>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/draw/picture_options.hpp"
#include "asterism/mesh/draw/report.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism {

// Options of writing.
struct write_options {
  picture_options picture;    // for .svg, .png and .pdf
  report_facts report = {};   // for .html
  physical_names names = {};  // for .msh, .su2 and .14
  // Sentence about the mesh, written as a comment in .mesh, .vtu and .svg.
  std::string note = {};
  // Given vertices, ascending, that are no corners though the boundary turns there: they divide a
  // curve. For .mesh and .meshb, which list corners and required vertices.
  std::vector<vertex_index> smooth = {};
  // False for a mesh without a meaningful metric, which is left out with all measures by it.
  bool with_metric = true;
  // Fields on the mesh: node data of .msh and .vtu; in NAME.sol beside a .mesh, where there is no
  // metric, and else in NAME.fields.sol. Other formats have no place for them. Not owned.
  const solution* fields = nullptr;
  // Order of triangles: 2 for second order, in .msh, .msh2 and .vtu; other formats have
  // straight sides. Values at vertices get values at the nodes of sides: the mean of both
  // ends.
  int order = 1;
  // Nodes of the sides that are not straight, ascending by their ends (pipeline/curved_sides.hpp
  // makes them, and proves that no triangle folds).
  std::vector<side_node> curved = {};
  // Markers of cracks: files of meshes have the vertices of both sides of their edges.
  crack_markers cracks = {};
};

}  // namespace asterism
