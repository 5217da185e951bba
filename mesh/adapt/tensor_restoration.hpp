// SPDX-License-Identifier: MIT
//
// Restores the wanted tensors at nodes where stars still agree then, by tests in doubles.
//
// A mesh is made and mended in a metric that is graded everywhere, and its stars agree in that.
// Most of its tensors need not differ from the wanted ones. So each node's wanted tensor is tried,
// or else a step towards it, one node after the other, as long as the edges and angles around it
// pass their tests (local_tests.hpp). Positions and edges stay. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

class tensor_restoration {
 public:
  // Takes one wanted tensor for each node. The present tensors are those to which an undone node
  // returns. The mesh must outlive the object.
  tensor_restoration(editable_mesh& m, double angle_bound, std::vector<metric_tensor> wanted);

  // Restores tensors until no node can change, or the limit on sweeps is reached: whole steps
  // first, then parts, unless hardly any node can make the whole step.
  void run(const cancellation& stop);
  // Undoes the changes of these nodes, and of nodes around them whose edges then disagree; none of
  // these is tried again. Adds the nodes that had been changed to `taken`.
  void take_back(const std::vector<vertex_index>& nodes, std::vector<vertex_index>& taken);
  // True if the node has been changed, and can be undone.
  bool has_given(vertex_index v) const { return !identical(m_.at(v).metric, before_[v]); }
  // Returns all nodes to the tensors they had, or that keep() was told of.
  void undo();
  // Makes the present tensors of these nodes those to which they return, and does not try these
  // nodes again.
  void keep(const std::vector<vertex_index>& nodes);

 private:
  bool give_once(bool whole_alone);
  bool give(vertex_index v, bool whole_alone);
  std::size_t wanted_count() const;
  bool has_low_face(const face_list& faces) const;
  void list_disagreeing(vertex_index v, std::vector<vertex_index>& out) const;

  editable_mesh& m_;
  local_tests tests_;
  present_centres present_;
  edges_around edges_;
  bool has_angles_;
  std::vector<metric_tensor> wanted_, before_;  // before_: or what was kept since
  std::vector<char> awake_, kept_;
};

}  // namespace asterism::internal::adapting
