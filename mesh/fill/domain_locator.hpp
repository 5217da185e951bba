// SPDX-License-Identifier: MIT
//
// Is a point strictly inside a domain, and which segments are near? `contains` of
// mesh/domain/point_in_domain.hpp with an index of the segments, for asking often. Exact.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

class domain_locator {
 public:
  // `d` must have been accepted by check_domain and outlive the locator.
  explicit domain_locator(const domain& d);

  // A point on a segment or a vertex is not inside. `q` finite. Safe to call from several threads,
  // each with its own kernel.
  bool contains(const filtered_kernel& kernel, const point& q) const;

 private:
  const domain* domain_;
  bounding_box box_;
  box_index segments_;
};

}  // namespace asterism::internal
