// SPDX-License-Identifier: MIT
//
// Answers the geometric questions of stars, which know only indices. Exact, but for the squared
// distance, which only chooses the order in which sites are tested.
#pragma once

#include <vector>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/edge_test_cache.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/stars/star_work_guard.hpp"

namespace asterism::internal {

// Answers questions about sites and a boundary, which may grow while it is in use, by a kernel. All
// these objects must outlive the oracle. With a memory (optional) a repeated edge_test is seldom
// computed again. With a neighbourhood (optional; it must know all sites and subsegments) only
// nearby sites and subsegments are searched; the answers are the same.
class site_oracle {
 public:
  site_oracle(const std::vector<site>& sites, const boundary& edges, const star_predicates& kernel,
              edge_test_cache* memory = nullptr, const proximity* near = nullptr)
      : sites_(&sites), boundary_(&edges), kernel_(&kernel), memory_(memory), near_(near) {}

  vertex_index size() const { return static_cast<vertex_index>(sites_->size()); }
  const boundary& edges() const { return *boundary_; }
  const std::vector<site>& sites() const { return *sites_; }
  const proximity* near() const { return near_; }
  const star_predicates& kernel() const { return *kernel_; }
  // Returns an oracle for another thread, with this kernel and a memory of its own, or
  // none.
  site_oracle with_kernel(const star_predicates& kernel, edge_test_cache* memory = nullptr) const {
    return {*sites_, *boundary_, kernel, memory, near_};
  }
  // Returns the same oracle with a work guard, which must outlive it.
  site_oracle guarded_by(star_work_guard& guard) const {
    site_oracle other = *this;
    other.guard_ = &guard;
    return other;
  }
  // True once the work limit was reached: the star is left as it is (stars/star_work_guard.hpp).
  bool is_over() const { return guard_ != nullptr && guard_->is_over(*kernel_); }

  // Returns the orientation of u, v, w: positive when they turn counter-clockwise.
  sign orientation(vertex_index u, vertex_index v, vertex_index w) const;
  // True if u, on the line through v and w, is on the same side of v as w.
  bool same_direction(vertex_index v, vertex_index w, vertex_index u) const;
  // True if the site `near` is nearer to v than the site `far`. Requires both on one ray from v.
  bool nearer_on_ray(vertex_index v, vertex_index near, vertex_index far) const;
  // True if v and w may be neighbours when x and y are their common neighbours (predicates/). Ties
  // are broken.
  bool edge_test(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const;
  // True if the open segment v w stays off the boundary (stars/visibility.hpp).
  bool visible(vertex_index v, vertex_index w) const;
  // True if the open segments v w and a b cross; false when they share an end.
  bool crosses(vertex_index v, vertex_index w, vertex_index a, vertex_index b) const;
  // Returns the squared distance of v and w as v measures it, in doubles.
  double squared_distance(vertex_index v, vertex_index w) const;
  // True if v comes before w in the order of sites by position, which breaks ties.
  bool precedes(vertex_index v, vertex_index w) const;

 private:
  const std::vector<site>* sites_;
  const boundary* boundary_;
  const star_predicates* kernel_;
  edge_test_cache* memory_;
  const proximity* near_;
  star_work_guard* guard_ = nullptr;
};

}  // namespace asterism::internal
