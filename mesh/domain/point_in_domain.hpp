// SPDX-License-Identifier: MIT
//
// Decides by exact signs whether a point is strictly inside a domain, or one of its regions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

// True if q is strictly inside. `d` must have been accepted by check_domain: only then does the
// number of segments on a ray, without internal ones, distinguish inside from outside. A point on a
// segment, internal or not, or on a vertex of one is not inside. `q` finite. Time: O(number of
// segments).
bool contains(const domain& d, const point& q);

// Decides for many points whether they are in a domain. Tests only the segments near a ray from
// each point.
class inside_index {
 public:
  // Prepares the domain, or one region of it. Requirements on `d` are those of contains(). Copies
  // the segments that it needs, so `d` need not outlive it.
  explicit inside_index(const domain& d, std::optional<int> region = {});

  // True if q is strictly inside: not on a segment between inside and outside. Segments with the
  // same region on both sides are ignored. May be called from any thread.
  bool contains(const point& q) const;
  // True if no segment bounds the region, which then does not exist.
  bool is_empty() const { return ends_.empty(); }

 private:
  struct ends {
    point a, b;
  };

  bounding_box box_;
  std::vector<ends> ends_;
  box_index segments_;
};

}  // namespace asterism::internal
