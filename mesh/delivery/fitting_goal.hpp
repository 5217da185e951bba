// SPDX-License-Identifier: MIT
//
// Holds the goal that a mesh is fitted to: a metric and a number of vertices. Both are the wanted
// ones, except that noise is filtered for few vertices, and that room is made beside segments and
// chords shorter than the metric's edges (docs/design/adaptation.md). Internal to mesh/pipeline.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class fitting_goal {
 public:
  // Takes the wanted metric and number of vertices, of at most `most`. The domain must outlive the
  // object.
  fitting_goal(const domain& shape, const background_metric& wanted, std::size_t count,
               std::size_t most)
      : domain_(shape), fitted_(wanted), count_(count), most_(most) {}

  // Returns the metric that the mesh is fitted to.
  const background_metric& metric() const { return fitted_; }
  // True if the mesh is fitted to another metric than the one wanted.
  bool is_other() const { return is_other_; }
  std::size_t count() const { return count_; }
  void set_count(std::size_t count) { count_ = count; }
  // True if the vertices are too few to resolve the metric.
  bool wants_few() const;
  // True if at least one vertex in ten is a vertex of the domain, and some segments are short. No
  // segment counts as short unless its ends are nodes of the background: room elsewhere would be
  // nothing but a stricter gradation.
  bool may_want_room() const;
  // True once the metric was refined at short segments.
  bool has_room() const { return has_room_; }

  // Filters shapes of tensors that are noise (mesh/adapt/shape_filter.hpp).
  void leave_out_noise(const cancellation& stop);
  // Makes room for short segments before the first mesh if it is known to be needed: at chords much
  // shorter than wanted, where so few vertices are wanted that angles at the domain's own vertices
  // cannot be met, or where the room takes a large share of all vertices. Otherwise the first mesh
  // shows whether it is needed.
  void make_room_where_needed(const cancellation& stop);
  // Refines the metric at short segments, and raises the number of vertices to this share of the
  // number that this takes. Angles need nodes there that the wanted metric does not ask for;
  // without them no attempt led to a mesh.
  void make_room_for_segments(double part, const cancellation& stop);
  // Drops the copy of the metric without room at chords: the metric with room can no longer be
  // given up.
  void keep_room_at_chords() { without_room_.reset(); }
  // Restores the metric that was not refined at short chords, so that the next mesh has needles
  // there; returns false if no such metric was kept.
  bool give_up_room_at_chords();
  // Raises the number of vertices, once, to the greatest with which short segments have room;
  // returns false if it is that already.
  bool take_all_room(const cancellation& stop) { return has_room_ && raise_count(1, stop); }

  // Returns the metric to be fitted, graded on the graph of its background by this distortion over
  // an edge of length one.
  background_metric graded(double distortion, const cancellation& stop) const;

 private:
  bool domain_has_many_vertices() const;
  bool raise_count(double part, const cancellation& stop);
  std::vector<double> room_factors() const;
  std::vector<metric_tensor> with_room(const cancellation& stop) const;
  std::vector<char> at_vertices_of_domain(const std::vector<point>& places) const;

  const domain& domain_;
  background_metric fitted_;
  bool is_other_ = false, has_room_ = false;
  std::size_t count_, most_;
  // Metric and flag before room was made at short chords, while that is tried.
  std::optional<std::pair<background_metric, bool>> without_room_;
};

}  // namespace asterism::internal
