// SPDX-License-Identifier: MIT
//
// Compares the work of a fill with the limit for its number of sites.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {

// Counts work in place of time, so that every fill ends at the same place. Counts are sums, which
// are the same for any number of threads.
class work_meter {
 public:
  // Adds a number of stars of older sites that new ones disturb.
  void count_disturbed(std::uint64_t stars) { disturbed_ += stars; }
  // Adds a number of sites and subsegments tested. Safe to call from several threads.
  void count_candidates(std::uint64_t looked_at) { candidates_ += looked_at; }
  // Adds a number of gaps that were made, or tested against a site. Safe to call from several
  // threads.
  void count_gaps(std::uint64_t looked_at) { gaps_ += looked_at; }

  // True if `parts` times the work done exceeds the limit for this number of sites. Fills of
  // metrics that sites can follow disturb 5 to 110 stars a site and test 30 to 2600 candidates a
  // site. Where metrics vary wildly every site disturbs a part of all others, and both numbers grow
  // with the number of sites. The limits, 200 stars and 25 x 200 candidates a site, are about twice
  // the largest numbers that fills of the first kind took.
  bool is_overworked(std::size_t sites, std::uint64_t parts = 1) const {
    constexpr std::uint64_t at_least = 500'000, for_each = 200, candidates_for_one = 25;
    const std::uint64_t most = at_least + for_each * sites;
    return parts * disturbed_ > most || parts * (candidates_ / candidates_for_one) > most;
  }

  // Returns the work done in the units of kernels/work_units.hpp. Where metrics vary wildly stars
  // have hundreds of gaps. Finding the gap of a site by bisection costs less than a test of each
  // gap; making such a star costs more than two microseconds.
  double units() const {
    return work_weights::approximate_star * static_cast<double>(disturbed_) +
           work_weights::plain_candidate * static_cast<double>(candidates_) +
           work_weights::approximate_gap * static_cast<double>(gaps_);
  }

 private:
  std::uint64_t disturbed_ = 0;
  std::atomic<std::uint64_t> candidates_ = 0;
  std::atomic<std::uint64_t> gaps_ = 0;
};

}  // namespace asterism::internal
