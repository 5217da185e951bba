// SPDX-License-Identifier: MIT
//
// Sorts items by small numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "asterism/mesh/support/parallel_for.hpp"

namespace asterism::internal {

// Sorts items 0 to count - 1 by group_of(item), which is below `groups`, and by the item within a
// group. Calls put(place, item) once for each item; several threads may call it. Returns the first
// place of each group, and the number of items. Takes O(count + groups) on each thread.
template <class Group, class Put>
std::vector<std::size_t> sort_by_counting(std::size_t count, std::size_t groups,
                                          const Group& group_of, const Put& put) {
  // Each thread counts a part of the items. More threads would add up counters for longer than they
  // save.
  constexpr std::size_t most_parts = 8, least_items = 16384;
  const std::size_t parts =
      std::clamp(count / least_items, std::size_t{1}, std::min(most_parts, thread_count()));
  std::vector<std::size_t> next(parts * groups, 0), begins(groups + 1);
  const auto each = [&](const auto& act) {
    parallel_for(parts, [&](std::size_t p) {
      const std::size_t end = (p + 1) * count / parts;
      for (std::size_t i = p * count / parts; i < end; ++i) act(p * groups + group_of(i), i);
    });
  };
  each([&](std::size_t counter, std::size_t) { ++next[counter]; });
  std::size_t place = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    begins[g] = place;
    for (std::size_t i = g; i < next.size(); i += groups) place += std::exchange(next[i], place);
  }
  begins[groups] = place;
  each([&](std::size_t counter, std::size_t i) { put(next[counter]++, i); });
  return begins;
}

}  // namespace asterism::internal
