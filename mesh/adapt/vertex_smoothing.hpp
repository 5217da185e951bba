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
// stay. Works in doubles; the result is a proposal. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/node_ring.hpp"
#include "asterism/mesh/adapt/ring_defect.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

class vertex_smoothing {
 public:
  // Function that returns the metric wanted at a place; `hint` speeds up the next look-up near it
  // (background_metric.hpp).
  using wanted_at = std::function<metric_tensor(const point& q, vertex_index& hint)>;

  // Takes the wanted length `unit` of an edge. The mesh must outlive the object.
  vertex_smoothing(editable_mesh& m, double angle_bound, double unit, wanted_at wanted);

  // True if the wanted metric varies so much over the edges that moves would help few nodes.
  bool is_in_vain() const;
  // Moves nodes until none has a better place, or the limit on sweeps is reached.
  void run(const cancellation& stop);

 private:
  // A place of a node with a smaller defect.
  struct place {
    point at;
    wanted_tensor wanted;
    vertex_index hint;
    double defect;
  };

  void find_defect_free();
  void unmark_around(vertex_index v);
  wanted_tensor look_up(const point& q, vertex_index& hint) const;
  // Products of coordinates of two sides u and w of a face: all that the angles in a tensor depend
  // on.
  struct side_products;
  side_products sides_of(vertex_index t) const;
  bool collect(edges_around& at, vertex_index v, ring_defect& ring) const;
  double present_defect(ring_defect& ring, vertex_index v) const;
  double energy_of(const node& there);
  void find_better_places(vertex_index v, double step, double now, double energy_now);
  bool stretches_edge(vertex_index v, const point& here, const place& there) const;
  bool may_be_at(vertex_index v, const place& there);
  bool take_place(vertex_index v);
  bool settle(vertex_index v);

  editable_mesh& m_;
  local_tests tests_;
  present_centres present_;
  edges_around edges_;
  ring_defect ring_;  // of the node at hand
  node_ring shapes_;  // of its faces
  node_ring::energies energies_;
  double angle_bound_, unit_;
  wanted_at field_;
  std::vector<wanted_tensor> wanted_;  // of each node
  std::vector<char> awake_;
  std::vector<char> is_defect_free_;  // by node, in the present mesh
  std::vector<place> better_;         // of the node at hand
};

}  // namespace asterism::internal::adapting
