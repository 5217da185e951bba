// SPDX-License-Identifier: MIT
//
// Geometry for topology: a star knows indices and asks its questions here. Exact, but for the
// squared distance, which only chooses the order in which sites are looked at.
#pragma once

#include <vector>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/edge_test_cache.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// All objects must outlive the oracle; sites and boundary may grow while it is in use. With a
// memory (optional) no edge_test is asked twice in a while. With a neighbourhood (optional; it must
// know all sites and subsegments) only what is near is looked at; the answers are the same.
class site_oracle {
 public:
  site_oracle(const std::vector<site>& sites, const boundary& edges, const star_predicates& kernel,
              edge_test_memory* memory = nullptr, const neighbourhood* near = nullptr)
      : sites_(&sites), boundary_(&edges), kernel_(&kernel), memory_(memory), near_(near) {}

  vertex_index size() const { return static_cast<vertex_index>(sites_->size()); }
  const boundary& edges() const { return *boundary_; }
  const std::vector<site>& sites() const { return *sites_; }
  const neighbourhood* near() const { return near_; }
  const star_predicates& kernel() const { return *kernel_; }
  // For another thread: asks this kernel, and remembers nothing.
  site_oracle with_kernel(const star_predicates& kernel) const {
    return {*sites_, *boundary_, kernel, nullptr, near_};
  }

  // Positive when u, v, w turn counter-clockwise.
  sign orientation(vertex_index u, vertex_index v, vertex_index w) const;
  // For u on the line through v and w: is it on the same side of v as w?
  bool same_direction(vertex_index v, vertex_index w, vertex_index u) const;
  // For near and far on one ray from v: is `near` nearer?
  bool nearer_on_ray(vertex_index v, vertex_index near, vertex_index far) const;
  // predicates/: may v and w be neighbours when x and y are their common ones? Ties broken.
  bool edge_test(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const;
  // stars/visibility.hpp: does the open segment v w stay off the boundary?
  bool visible(vertex_index v, vertex_index w) const;
  // Do the open segments v w and a b cross? No when they share an end.
  bool crosses(vertex_index v, vertex_index w, vertex_index a, vertex_index b) const;
  // As v measures it, in doubles.
  double squared_distance(vertex_index v, vertex_index w) const;
  // The tie-breaking order of sites, by position.
  bool precedes(vertex_index v, vertex_index w) const;

 private:
  const std::vector<site>* sites_;
  const boundary* boundary_;
  const star_predicates* kernel_;
  edge_test_memory* memory_;
  const neighbourhood* near_;
};

}  // namespace asterism::internal
