// SPDX-License-Identifier: MIT
//
// Writes meshes for programs without metrics and segments inside: SU2's .su2, and Triangle's .node,
// .ele and .edge.
#pragma once

#include <string>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism::internal {

// Returns the contents of a .su2 file: triangles, points, and the boundary by markers, each with
// its number or its name, blanks as underscores, for a tag. The format has no place for internal
// segments and regions. Source: SU2 v8 documentation, "Mesh File".
std::string su2_text(const mesh& m, const physical_names& names);

// Returns the contents of NAME.node: positions, the metric as three attributes, and a marker of the
// boundary there, 0 inside. All three files count from 1. Source:
// https://www.cs.cmu.edu/~quake/triangle.node.html, .ele.html and .edge.html.
std::string node_text(const mesh& m);
// Returns the contents of NAME.ele: triangles with their region as an attribute.
std::string ele_text(const mesh& m);
// Returns the contents of NAME.edge: boundary subsegments, internal ones too, with their markers.
std::string edge_text(const mesh& m);

}  // namespace asterism::internal
