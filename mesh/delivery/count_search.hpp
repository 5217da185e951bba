// SPDX-License-Identifier: MIT
//
// Searches for the factor of a metric that gives the number of sites wanted, by making meshes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/target_search.hpp"

namespace asterism::internal {

// Returns the number of vertices to aim at for this factor of the metric, within the limit on
// sites.
inline std::size_t count_aimed_at(std::size_t wanted, double factor, std::size_t max_sites) {
  constexpr double fewest = 3;
  const double aim = std::round(factor * static_cast<double>(wanted));
  return static_cast<std::size_t>(std::clamp(aim, fewest, static_cast<double>(max_sites)));
}

// Searches for the factor of the metric with which a mesh has the number of vertices wanted.
//
// The number grows with the factor, in steps where a domain is narrow: all subsegments of one
// length are halved at once, and no factor may lead to a number between.
class count_search {
 public:
  // `slowest` is the least exponent p in sites ~ factor^p that is assumed: 1 where all sites depend
  // on the factor, less where some do not, as on a boundary with narrow parts.
  explicit count_search(double wanted, double slowest = 1) : wanted_(wanted), search_(slowest) {}

  // Returns the factor to try next, 1 to begin with.
  double factor() const { return elementary::exp(search_.at()); }
  // Returns the smallest |log(sites / wanted)| found so far.
  double least_off() const { return search_.least_off(); }

  // Enters the number of sites of the mesh made with the last factor. Returns whether it is the
  // nearest to the number wanted so far.
  bool take(double sites) { return search_.take(elementary::log(sites / wanted_)); }

 private:
  double wanted_;
  target_search search_;
};

}  // namespace asterism::internal
