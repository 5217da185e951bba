// SPDX-License-Identifier: MIT
//
// Holds what a mesh is fitted to: a metric, and how many vertices it is to have. Both are the ones
// wanted, but for noise of few vertices, and for room beside segments and chords shorter than the
// metric wants edges (docs/design/adaptation.md). Internal to mesh/pipeline.
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
  // Wants this metric and so many vertices, of at most `most`. The domain must outlive the object.
  fitting_goal(const domain& shape, const background_metric& wanted, std::size_t count,
               std::size_t most)
      : domain_(shape), fitted_(wanted), count_(count), most_(most) {}

  // Returns the metric that the mesh is fitted to.
  const background_metric& metric() const { return fitted_; }
  // True if that is another one than the one wanted.
  bool is_other() const { return is_other_; }
  std::size_t count() const { return count_; }
  void set_count(std::size_t count) { count_ = count; }
  // True if vertices are so few that they do not resolve the metric yet.
  bool wants_few() const;
  // True if one vertex of ten or more is one of the domain.
  bool domain_has_many_vertices() const;
  // True once the metric was refined at short segments.
  bool has_room() const { return has_room_; }

  // Leaves out shapes that are noise (mesh/adapt/shape_filter.hpp).
  void leave_out_noise(const cancellation& stop);
  // Makes room for short segments at once where it is known to be needed: at chords much shorter
  // than wanted, where so few vertices are wanted that angles at the domain's own vertices cannot
  // be met, or where the room takes a good part of all vertices. Otherwise the first mesh shows
  // whether it is needed.
  void make_room_where_needed(const cancellation& stop);
  // Refines the metric at short segments, and raises the number of vertices to this part of what
  // that takes. Angles need nodes there that the metric wanted does not have; without them no
  // attempt led to a mesh with so many nodes.
  void make_room_for_segments(double part, const cancellation& stop);
  // Forgets the metric without room at chords.
  void keep_room_at_chords() { without_room_.reset(); }
  // Goes back to the metric without room at chords; returns false if there is none. The mesh made
  // then has needles there.
  bool give_up_room_at_chords();
  // Raises the number of vertices, once, to the greatest for which short segments leave room; false
  // if it is that already.
  bool take_all_room(const cancellation& stop) { return has_room_ && raise_count(1, stop); }

  // Returns the metric to be fitted, graded on the graph of its background by this distortion over
  // an edge of length one.
  background_metric graded(double distortion, const cancellation& stop) const;

 private:
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
