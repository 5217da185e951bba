// SPDX-License-Identifier: MIT
//
// Weighs answers of the kernel by their cost. The unit is about ten microseconds, so that a million
// of them are ten seconds.
//
// Measured by the processor time of runs that do little else (x86_64, Release): an orientation
// takes 10 to 15 nanoseconds with everything around it, and 50 to 70 in exact integers; an edge
// test 0.3 to 1 microseconds in doubles and 20 in intervals; in exact numbers a few microseconds if
// all tensors are the same, else 100 to 100,000. The last are weighed by the number of limbs
// multiplied. Weights bound work and are no clock: where a run ends depends on counts alone.
#pragma once

#include <cstddef>

#include "asterism/kernels/tier_counters.hpp"

namespace asterism::internal {

// Weight of one answer of each tier.
struct tier_weights {
  double semi_static, interval, exact;
};

inline constexpr tier_weights weights_of(predicate which) {
  switch (which) {
    case predicate::edge_test:
    case predicate::insertion_test:
      return {0.1, 2, 0.5};
    case predicate::encroaches:
      return {0.006, 0.3, 0.5};
    case predicate::voronoi_vertex_count:
    case predicate::arc_intersection_count:
      return {0.1, 0.3, 0.5};
    default:
      return {0.0015, 0.01, 0.007};
  }
}

// Number of products of two limbs in one unit, with the operations around them.
inline constexpr double products_for_unit = 12000;

// Weight of an item visited: four nanoseconds.
inline constexpr double an_item_looked_at = 0.0004;

// Returns the work of all answers counted, and of visiting items to find the questions.
inline double work_units(const tier_counters& counts) {
  double units = static_cast<double>(counts.limb_products) / products_for_unit +
                 an_item_looked_at * static_cast<double>(counts.looked_at);
  for (std::size_t i = 0; i < predicate_count; ++i) {
    const auto which = static_cast<predicate>(i);
    const tier_weights w = weights_of(which);
    units += w.semi_static * static_cast<double>(counts.at(which, tier::semi_static)) +
             w.interval * static_cast<double>(counts.at(which, tier::interval)) +
             w.exact * static_cast<double>(counts.at(which, tier::exact));
  }
  return units;
}

}  // namespace asterism::internal
