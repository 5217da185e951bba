// SPDX-License-Identifier: MIT
//
// Gives nodes back the tensors wanted, where stars go on agreeing, as far as doubles can tell.
//
// A mesh is made and mended in a metric that is graded all over, and its stars agree in that. Most
// tensors need not have been changed for it. So each is tried as it was wanted, and else moved
// part of the way, one node after the other, as long as the edges and angles around it are in order
// (local_tests.hpp). Positions and edges stay. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

class tensor_restoration {
 public:
  // `wanted` has a tensor for each node. Those the nodes have are the ones to return to. The mesh
  // must outlive the object.
  tensor_restoration(working_mesh& m, double angle_bound, std::vector<metric_tensor> wanted);

  // Restores tensors until no node can change, or sweeps are over: whole tensors first, then parts
  // of the way, unless hardly any node can have the whole.
  void run(const cancellation& stop);
  // Undoes the changes of these nodes, and of those around whose edges do not agree then; these
  // nodes are not tried again. Adds the nodes that had been changed to `taken`.
  void take_back(const std::vector<vertex_index>& nodes, std::vector<vertex_index>& taken);
  // True if the node has been changed, so that it can be undone.
  bool has_given(vertex_index v) const { return !identical(m_.at(v).metric, before_[v]); }
  // Has undoing return to the present tensors of these nodes, and does not try them again.
  void keep(const std::vector<vertex_index>& nodes);

 private:
  bool give_once(bool whole_alone);
  bool give(vertex_index v, bool whole_alone);
  std::size_t wanted_count() const;
  bool has_low_around(vertex_index v) const;
  void list_disagreeing(vertex_index v, std::vector<vertex_index>& out) const;
  void wake_around(vertex_index v);

  working_mesh& m_;
  local_tests tests_;
  edges_around edges_;
  bool has_angles_;
  std::vector<metric_tensor> wanted_, before_;  // before_: or what was kept since
  std::vector<char> awake_, kept_;
};

}  // namespace asterism::internal::adapting
