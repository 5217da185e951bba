// SPDX-License-Identifier: MIT
//
// Bounds the work in predicates, by the number of sites, after which a refinement is given up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Returns the work limit for this number of sites, in units of kernels/work_units.hpp.
//
// Meshes that become complete take 7 to 700 edge tests a site, the most where metrics are so thin
// (condition 1e16) that all tests need exact numbers, and 60 to 13000 orientations (of sites with
// respect to subsegments of the boundary, where no metric shows which sites are near). Where
// metrics vary wildly every site is in reach of every other and of every subsegment: both grow with
// the number of sites, and no mesh is possible. The `given` vertices may all see each other before
// there is a site between them, for instance on a convex polygon; so every pair of them has an
// allowance. The limit is ten seconds on one core for 3,000 sites and thirty for 100,000, the
// default limit on sites; meshes of that size take 5 to 20 units a site.
inline double most_work_units(std::size_t sites, std::size_t given) {
  constexpr double at_least = 4e5, for_each = 150, first_ones = 5000, for_more = 20, a_pair = 1,
                   pairs_at_most = 3e5;
  const auto n = static_cast<double>(sites), g = static_cast<double>(given);
  return at_least + for_each * std::min(n, first_ones) + for_more * std::max(0.0, n - first_ones) +
         std::min(a_pair * g * g, pairs_at_most);
}

// Returns the work done as a part of that limit; above 1 the run is abandoned.
inline double part_of_work_bound(const tier_counters& counts, std::size_t sites,
                                 std::size_t given) {
  return work_units(counts) / most_work_units(sites, given);
}

// Work limit of a whole run, in units, whatever it tries: ten seconds on one core, and 0.08
// milliseconds a site. A mesh of a million triangles takes two fifths of that, an adaptation that
// meets its metric 9 units a site. The audit of the result has its own limit
// (audit/audit_work.hpp).
constexpr double units_for_run = 1e6, run_units_for_site = 8;

// Returns the stop of a run with an account of the work it may do, unless it has one already:
// `times` the limit where a run may need several attempts.
inline cancellation with_run_work(const cancellation& stop, double times = 1) {
  const bool has_account = stop.units_left() < std::numeric_limits<double>::infinity();
  return has_account ? stop : stop.with_work(times * units_for_run, times * run_units_for_site);
}

// Work limit, in units, of a mesh in one metric for all sites, made after one in the metric given
// was abandoned.
constexpr double units_for_constant_metric = 3e5;

}  // namespace asterism::internal
