// SPDX-License-Identifier: MIT
//
// Moves nodes to where the metric wanted finds better angles, in a mesh that agrees in another one.
//
// A mesh is made and mended in a metric that is graded all over. What is in the way of giving a
// node back the tensor wanted (tensor_restoration.hpp) is, more often than not, an angle that this
// tensor finds a few degrees below the bound, or a face across from the node whose star it would be
// in. So nodes are moved a little while there is less of that, as far as edges and angles stay in
// order in the tensors that the nodes have. These stay, and so do the edges. In doubles; a
// proposal. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

class vertex_smoothing {
 public:
  // Metric wanted at a place; `hint` helps the next look-up near it (background_metric.hpp).
  using wanted_at = std::function<metric_tensor(const point& q, vertex_index& hint)>;

  // `unit` is the length wanted of an edge. The mesh must outlive the object.
  vertex_smoothing(working_mesh& m, double angle_bound, double unit, wanted_at wanted);

  // True if the metric wanted varies so much over the edges that moving would help few nodes.
  bool is_in_vain() const;
  // Moves nodes until none has a better place, or sweeps are over.
  void run(const cancellation& stop);

 private:
  // Tensor wanted of a node.
  struct wanted_tensor {
    metric_tensor metric;
    double root = 0;  // of its determinant
  };
  // Place of a node that is better for the angles.
  struct place {
    point at;
    wanted_tensor wanted;
    vertex_index hint;
    double defect;
  };

  void find_calm();
  void disturb_around(vertex_index v);
  wanted_tensor look_up(const point& q, vertex_index& hint) const;
  double excess_of(vertex_index t, vertex_index by) const;
  double defect_of(vertex_index t, vertex_index by) const;
  double defect_of_others(const edges_around& at, vertex_index v, double most) const;
  double defect_of_own(edges_around& at, vertex_index v) const;
  double energy() const;
  void find_better_places(vertex_index v);
  bool stretches_edge(vertex_index v, const point& here, const place& there) const;
  bool may_be_at(vertex_index v, const place& there);
  bool settle(vertex_index v);

  working_mesh& m_;
  local_tests tests_;
  edges_around edges_;
  double angle_bound_, cotangent_, unit_;
  wanted_at field_;
  std::vector<wanted_tensor> wanted_;  // of each node
  std::vector<char> awake_;
  std::vector<char> calm_;     // nodes at which nothing is amiss, as the mesh is
  std::vector<place> better_;  // of the node at hand
};

}  // namespace asterism::internal::adapting
