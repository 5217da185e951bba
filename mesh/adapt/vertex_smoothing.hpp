// SPDX-License-Identifier: MIT
//
// Moves nodes to places with better angles in the wanted metric, in a mesh whose stars agree in
// another one.
//
// A mesh is made and mended in a metric that is graded everywhere. A node's wanted tensor
// (tensor_restoration.hpp) cannot be restored mostly because it measures an angle a few degrees
// below the bound, or because the node would then be nearer to the Voronoi vertex of a face across
// from it than the face's own sites are. So nodes are moved a little as long as these defects
// decrease, and as edges and angles pass their tests in the present tensors. Tensors and edges
// stay. Works in doubles; the result is a proposal.
//
// The place of a node depends on those of nodes near it, so the order matters. Large meshes are
// divided into parts along a curve, whatever the number of threads. In each sweep nodes far from
// other parts are moved first, part by part, by several threads; then all others, by one. Internal
// to mesh/adapt.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/adapt/curve_parts.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/node_settling.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

class vertex_smoothing {
 public:
  using wanted_at = mesh_to_smooth::wanted_at;

  // Takes the wanted length `unit` of an edge. The mesh must outlive the object.
  vertex_smoothing(editable_mesh& m, double angle_bound, double unit, wanted_at wanted);

  // True if the wanted metric varies so much over the edges that moves would help few nodes.
  bool is_in_vain() const;
  // Moves nodes until none has a better place, or the limit on sweeps is reached.
  void run(const cancellation& stop);

 private:
  void find_defect_free();
  void divide();
  std::vector<char> nodes_near_other_parts(const curve_parts& parts);
  bool settle_part(std::size_t part);
  // Products of coordinates of two sides u and w of a face: all that the angles in a tensor depend
  // on.
  struct side_products;
  side_products sides_of(vertex_index t) const;

  mesh_to_smooth whole_;
  double angle_bound_, cotangent_;   // the latter of the least angle without defect
  std::vector<vertex_index> nodes_;  // that may be moved, part by part; those near others last
  std::vector<std::size_t> first_;   // of each part in nodes_, of the last ones, and their end
};

}  // namespace asterism::internal::adapting
