// SPDX-License-Identifier: MIT
//
// Walks over the triangles of a mesh, across all edges that a ball meets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/metric_ball.hpp"

namespace asterism::internal::audit_detail {

class triangle_walk {
 public:
  // Both must outlive it; sites by vertex. Requires matched edges.
  triangle_walk(const audit_context& context, const std::vector<site>& at)
      : context_(context), at_(at) {}

  // Begins anew, around another site. At most so many triangles are met.
  void begin(const metric_ball& ball, double radius, std::size_t most) {
    ball_ = &ball;
    radius_ = radius;
    most_ = most;
    met_.clear();
    ahead_.clear();
    meets_boundary_ = false;
  }

  const std::vector<vertex_index>& met() const { return met_; }
  bool is_met(vertex_index t) const { return std::find(met_.begin(), met_.end(), t) != met_.end(); }
  bool is_too_long() const { return met_.size() > most_; }
  // True if the ball meets a piece of the boundary that the walk came to.
  bool meets_boundary() const { return meets_boundary_; }

  void take(vertex_index t) { met_.push_back(t); }

  // Returns the edge from b to a, of the triangle across the edge from a to b, if the ball meets
  // that, and it is no piece of the boundary; or the number of all edges.
  std::size_t across(vertex_index a, vertex_index b) {
    if (metric_ball::misses(place(a), place(b), radius_)) return context_.edges.size();
    const std::size_t e = find_edge(context_, b, a);
    meets_boundary_ = meets_boundary_ || e == context_.edges.size();
    return e;
  }

  // Goes on across the edge from a to b, if the ball meets it.
  void cross(vertex_index a, vertex_index b) {
    const std::size_t e = across(a, b);
    if (e != context_.edges.size()) ahead_.push_back(e);
  }

  // Goes on from the triangle of the edge across its other edges.
  void cross_others(const directed_edge& e) {
    cross(e.b, e.apex);
    cross(e.apex, e.a);
  }

  // Goes all the way; calls visit(edge) for each triangle met that was not before, with the edge
  // through which it was entered. False if that is too long.
  template <class Visit>
  bool go(const Visit& visit) {
    while (!ahead_.empty() && !is_too_long()) {
      const directed_edge& e = context_.edges[ahead_.back()];
      ahead_.pop_back();
      if (is_met(e.triangle)) continue;
      take(e.triangle);
      visit(e);
      cross_others(e);
    }
    return !is_too_long();
  }

 private:
  point place(vertex_index v) const { return ball_->in_frame(at_[v].position); }

  const audit_context& context_;
  const std::vector<site>& at_;
  const metric_ball* ball_ = nullptr;
  double radius_ = 0;
  std::size_t most_ = 0;
  std::vector<vertex_index> met_;
  std::vector<std::size_t> ahead_;  // edges of triangles to enter through them
  bool meets_boundary_ = false;
};

}  // namespace asterism::internal::audit_detail
