// SPDX-License-Identifier: MIT
//
// Inserts sites at candidates on Voronoi arcs, for one bad triangle after the other or for many at
// once. The tolerance shrinks when no candidate can be inserted.
#pragma once

#include <cstddef>
#include <set>

#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/steepness.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class arc_insertion {
 public:
  // Starts with the tolerance `range.start`. All references must outlive the object.
  arc_insertion(refine_state& state, const bad_triangle_queue& queue, steepness& steep,
                const angle_requirement& angle, const tolerance_range& range,
                const cancellation& cancelled)
      : state_(state),
        queue_(queue),
        steep_(steep),
        angle_(angle),
        range_(range),
        cancelled_(cancelled),
        tolerance_(range.start) {}

  // Inserts a site for the worst triangle that can be mended, and shrinks the tolerance while none
  // can. Returns false when the tolerance is at its floor and nothing can be inserted, or the field
  // failed. Returns true without an insertion when the run is cancelled or overworked, which the
  // loop then detects.
  bool insert();
  // Inserts a site each for many bad triangles; does nothing when they are few. Skips a triangle
  // that shares a site or a neighbour with a triangle that got a site: it has to be examined again
  // first. Splits no subsegments; insert() does, one by one. Returns false when nothing was
  // inserted.
  bool insert_in_bulk();
  // Inserts a site for a triangle at a sharp corner that has other low angles besides the corner's;
  // true if one was inserted. Keeps the distance between sites near the first tolerance, so that
  // this cannot go on without end.
  bool insert_at_exempt_corners();

  // From now on, tries candidates nearer to the triangles as well: for collateral angles.
  void mend_collateral() { mends_collateral_ = true; }

  double tolerance() const { return tolerance_; }  // in force
  // Returns the number of candidates that were tried and refused.
  std::size_t rejected() const { return rejected_; }

 private:
  enum class pass_result { progressed, field_failed, exhausted };

  pass_result insert_at_worst();
  // Splits a subsegment that has, just beyond it, a candidate of a bad triangle, for the worst
  // triangle where that is possible; returns true if one was split.
  bool split_before_worst();
  void insert_for_large();
  bool insert_at(const triangle& t, double tolerance);
  bool is_set_aside(const bad_triangle& b) const {
    return failed_at_tolerance_.count(b) != 0 || steep_.is_given_up(b.where);
  }

  refine_state& state_;
  const bad_triangle_queue& queue_;
  steepness& steep_;
  angle_requirement angle_;
  tolerance_range range_;
  const cancellation& cancelled_;
  double tolerance_;
  std::set<bad_triangle> failed_at_tolerance_;  // tried in vain with the tolerance in force
  bool retry_ = false;  // true if a site was inserted since one of them failed
  std::size_t rejected_ = 0;
  bool mends_collateral_ = false;
};

}  // namespace asterism::internal
