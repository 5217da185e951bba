// SPDX-License-Identifier: MIT
//
// Decides whether a point is strictly inside a domain, and finds the segments near it. It answers
// as `contains` of mesh/domain/point_in_domain.hpp, and has an index of the segments for many
// points. Exact.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

class domain_locator {
 public:
  // Builds the locator. `d` must have been accepted by check_domain and outlive the locator.
  explicit domain_locator(const domain& d);

  // True if q, which must be finite, is strictly inside, on no segment and no vertex. Safe to call
  // from several threads, each with its own kernel.
  bool contains(const filtered_kernel& kernel, const point& q) const;

 private:
  const domain* domain_;
  bounding_box box_;
  box_index segments_;
};

}  // namespace asterism::internal
