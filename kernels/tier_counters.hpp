// SPDX-License-Identifier: MIT
//
// Counts how many questions each tier of the filtered kernel decided, per predicate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace asterism {

// The predicates that are counted, those of predicates/.
enum class predicate : std::size_t {
  orientation,
  is_positive_definite,
  compare_distance,
  in_wedge,
  dominates,
  voronoi_vertex_count,
  arc_intersection_count,
  encroaches,
  insertion_test,
  edge_test,
  in_circle,
};
// Number of predicates.
inline constexpr std::size_t predicate_count = 11;
// Names of the predicates in the batch protocol, in the order of `predicate`.
inline constexpr std::array<std::string_view, predicate_count> predicate_names = {
    "orientation",
    "is_spd",
    "compare_distance",
    "in_wedge",
    "dominates",
    "voronoi_vertex_count",
    "arc_intersection_count",
    "encroaches",
    "insertion_test",
    "edge_test",
    "in_circle"};

// The tiers of the filtered kernel in the order they are tried (docs/math/tiers.md).
enum class tier : std::size_t { semi_static, interval, exact };
// Number of tiers.
inline constexpr std::size_t tier_count = 3;
// The names of the tiers, in order.
inline constexpr std::array<std::string_view, tier_count> tier_names = {"semi-static", "interval",
                                                                        "exact"};

// Counts of decisions, by predicate and tier.
struct tier_counters {
  std::array<std::array<std::uint64_t, tier_count>, predicate_count> decided{};
  // Work of the exact answers about sites, in products of two 64-bit limbs (core/integer.hpp). One
  // answer takes from hundreds to hundreds of millions.
  std::uint64_t limb_products = 0;
  // Number of items visited while questions are prepared, such as subsegments near a line of sight.
  std::uint64_t looked_at = 0;

  std::uint64_t& at(predicate p, tier t) {
    return decided[static_cast<std::size_t>(p)][static_cast<std::size_t>(t)];
  }
  std::uint64_t at(predicate p, tier t) const {
    return decided[static_cast<std::size_t>(p)][static_cast<std::size_t>(t)];
  }
  tier_counters& operator+=(const tier_counters& other) {
    for (std::size_t p = 0; p < predicate_count; ++p)
      for (std::size_t t = 0; t < tier_count; ++t) decided[p][t] += other.decided[p][t];
    limb_products += other.limb_products;
    looked_at += other.looked_at;
    return *this;
  }
};

}  // namespace asterism
