// SPDX-License-Identifier: MIT
//
// Bounds how much the predicates are asked for so many sites before a refinement is given up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "asterism/kernels/tier_counters.hpp"

namespace asterism::internal {

// Returns the work done as a part of the most that is allowed; above 1 the run is abandoned.
//
// Meshes that become complete take 7 to 700 edge tests a site, the most where metrics are so thin
// (condition 1e16) that all come to exact numbers. They take 60 to 13000 answers of other
// predicates, nearly all of them orientations (of sites with respect to subsegments of the
// boundary, where no metric says what is near). Where metrics vary wildly every site is in reach of
// every other and of every subsegment: both counts grow with the number of sites. The `given`
// vertices may all see each other before there is a site between them, for instance on a convex
// polygon; so every pair of them has an allowance. Where tensors are so thin that only exact
// arithmetic is left, no mesh is within reach. An exact answer counts as many as it takes the time
// of (number_spread.hpp), so that such runs end in seconds, not hours.
inline double part_of_work_bound(const tier_counters& counts, std::size_t sites,
                                 std::size_t given) {
  constexpr double edge_tests_at_least = 2e5, edge_tests_for_each = 1e3, edge_tests_a_pair = 20,
                   others_at_least = 1e8, others_for_each = 1e5, others_a_pair = 1000;
  std::uint64_t edge_tests = 0, others = 0;
  for (std::size_t which = 0; which < predicate_count; ++which) {
    const auto of = static_cast<predicate>(which);
    (of == predicate::edge_test ? edge_tests : others) += counts.at(of, tier::semi_static) +
                                                          counts.at(of, tier::interval) +
                                                          counts.at(of, tier::exact);
  }
  const double weighed = static_cast<double>(edge_tests + counts.spread_wide);
  const auto n = static_cast<double>(sites), g = static_cast<double>(given);
  const double most_edge_tests =
      edge_tests_at_least + edge_tests_for_each * n + edge_tests_a_pair * g * g;
  const double most_others = others_at_least + others_for_each * n + others_a_pair * g * g;
  return std::max(weighed / most_edge_tests, static_cast<double>(others) / most_others);
}

}  // namespace asterism::internal
