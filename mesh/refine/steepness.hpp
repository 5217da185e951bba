// SPDX-License-Identifier: MIT
//
// Finds triangles at which the metric varies faster than sites could resolve, and gives them up:
// more sites would pile up there for ever.
#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/refine_state.hpp"

namespace asterism::internal {

class steepness {
 public:
  // `finest` is the least distance of sites that a varying metric may need. All references must
  // outlive the object.
  steepness(refine_state& state, const mesh_options& options, double finest)
      : state_(state), options_(options), finest_(finest) {}

  // True if the triangle, or one that shares a site with it, lies across a place where the metric
  // varies too fast; it is then given up for good. False for strategies other than `fill`.
  bool gives_up(const bad_triangle& b);
  bool is_given_up(const triangle& t) const { return given_up_.count(t) != 0; }

  // True if a triangle that was given up disagrees. Local repair cannot cure an inconsistency
  // across a jump of the metric.
  bool jump_disagrees() const { return jump_disagrees_; }
  // True if another metric is to be delivered for such a triangle, and the whole domain meshed anew
  // (delivery/metric_delivery.hpp): then refinement elsewhere is useless.
  bool awaits_other_metric() const { return options_.metric_tolerance != 0.0 && jump_disagrees_; }
  // True if enough sites were inserted since the first triangle was given up. The mesh cannot
  // become complete any more, and beside a jump of the metric stars with thousands of neighbours
  // keep the others from agreeing; continuing to the floor of the tolerance would take days.
  bool has_waited_enough() const;
  // Returns the number of sites inserted since the first triangle was given up, or all if none was.
  std::size_t sites_since() const { return state_.sites().size() - sites_at_first_; }

  // Returns the place of the first triangle that was given up, with the number of all of them;
  // nothing if there are none.
  std::optional<steep_place> first_place(const std::set<bad_triangle>& bad) const;

 private:
  bool is_too_steep(const triangle& t);
  double steepest_between(site p, site q, double enough);

  refine_state& state_;
  const mesh_options& options_;
  double finest_;
  std::set<triangle> given_up_;
  std::set<vertex_index> at_jump_;  // sites of the triangles across steep places
  std::size_t sites_at_first_ = 0;  // when the first triangle was given up
  bool jump_disagrees_ = false;
};

}  // namespace asterism::internal
