// SPDX-License-Identifier: MIT
//
// Holds what is written of a mesh.
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
  // A sentence about the mesh for whoever opens the file: a comment in .mesh, .vtu and .svg.
  std::string note = {};
  // Given vertices, ascending, that are no corners though the boundary turns there: they divide a
  // curve. For .mesh and .meshb, which list corners and what must stay.
  std::vector<vertex_index> smooth = {};
  // False for a mesh whose metric says nothing, and is left out, as is what is measured by it.
  bool with_metric = true;
  // Fields on the mesh: node data of .msh and .vtu; in NAME.sol beside a .mesh, where there is no
  // metric, and else in NAME.fields.sol. Other formats have no place for them. Not owned.
  const solution* fields = nullptr;
  // 2: triangles of second order, for .msh, .msh2 and .vtu; other formats have straight sides
  // alone. What is at the vertices is at the nodes of sides, too: the mean of what is at their
  // ends.
  int order = 1;
  // Nodes of the sides that are not straight, ascending by their ends (pipeline/curved_sides.hpp
  // makes them, and proves that no triangle folds).
  std::vector<side_node> curved = {};
  // Edges of these markers are parted: files of meshes have the vertices of both their sides.
  crack_markers cracks = {};
};

}  // namespace asterism
