// SPDX-License-Identifier: MIT
//
// Holds the sites of a C program, with their boundary, for the functions of stars.h.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/c_interface/stars.h"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

struct asterism_sites {
  std::vector<asterism::site> all;
  std::set<std::pair<double, double>> places;         // of all of them
  asterism::internal::boundary edges;                 // without subsegments the domain is the plane
  std::optional<asterism::internal::proximity> near;  // without it answers are the same, slower
  std::size_t splits = 0;
  bool broken = false;  // memory ran out in the middle of a change

  bool is_place_taken(const asterism::point& p) const { return places.count({p.x, p.y}) != 0; }
  bool is_bounded() const { return !edges.subsegments().empty(); }
};

namespace asterism::internal {

// Returns the oracle that answers a star's questions about these sites.
class questioner {
 public:
  explicit questioner(const asterism_sites& sites)
      : oracle_(sites.all, sites.edges, kernel_, nullptr, sites.near ? &*sites.near : nullptr) {}
  const site_oracle& oracle() const { return oracle_; }
  const star_predicates& kernel() const { return kernel_; }

 private:
  tier_counters decided_;
  star_predicates_on<filtered_kernel> kernel_{decided_};
  site_oracle oracle_;
};

}  // namespace asterism::internal
