// SPDX-License-Identifier: MIT
//
// Writes VTK unstructured grids (.vtu) for ParaView and VTK: markup, and in it the
// numbers in base64 ("binary"), little-endian, each array behind the count of its bytes
// in 64 bits. Raw bytes after the markup ("appended") would be a quarter less. But VTK
// cannot read them with an expat that defers the parsing of unfinished tokens, as it
// does from version 2.6 on and in Debian 12's update of 2.5: seen with Debian's ParaView
// 5.11.
//
// Cells: the triangles, then the disagreeing triangles, of second order (type 22) with nodes for
// their sides after the vertices, if they are given. Point data: `metric` (m11 m12 m22),
// `metric_tensor` (3x3, rows one after the other, 1 for z), `star_size` (triangles at the vertex),
// `given` (1 for the domain's own vertices). Cell data: `smallest_angle` (degrees, the least of the
// nine angles seen from the three vertices), `disagreeing` (1 or 0), `region` (0 for disagreeing
// ones). Field data: `boundary`, for each subsegment its two points, its marker and the number of
// its segment, from 0. Source: "VTK File Formats", the XML section (docs.vtk.org).
#pragma once

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/side_node_mesh.hpp"

namespace asterism::internal {

// Values at the vertices. Without the metric the least angles are left out, too.
struct vtu_contents {
  bool with_metric = true;
  const solution* fields = nullptr;  // point data; none, or not owned
  // Nodes of second-order triangles; null for straight sides. Not owned; the mesh is its content.
  const side_node_mesh* nodes = nullptr;
};

// Gives the contents of the file to the sink; the first piece contains the first line.
void write_vtu(const mesh& m, const vtu_contents& values, const byte_sink& put);

}  // namespace asterism::internal
