// SPDX-License-Identifier: MIT
//
// Loops and sorting by as many threads as the caller may have (thread_limit.hpp).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>

#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/mesh/support/thread_pool.hpp"

namespace asterism::internal {

// Calls body(i) for each i below count.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  const auto part = [](const void* work, std::size_t begin, std::size_t end) {
    const Body& do_one = *static_cast<const Body*>(work);
    for (std::size_t i = begin; i < end; ++i) do_one(i);
  };
  if (count < 2 || thread_count() == 1)
    part(&body, 0, count);
  else
    run_loop(count, part, &body);
}

// Sorts parts, then merges them by pairs. No two items may be equivalent, as these have any order.
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, const Less& less = {}) {
  constexpr std::size_t least_items = 2048;  // of a part
  const auto count = static_cast<std::size_t>(end - begin);
  const std::size_t parts = std::bit_floor(std::min(4 * thread_count(), count / least_items));
  if (parts < 2 || thread_count() == 1) return std::sort(begin, end, less);
  const auto place = [&](std::size_t part) {
    return begin + static_cast<std::iter_difference_t<Iterator>>(part * count / parts);
  };
  parallel_for(parts, [&](std::size_t p) { std::sort(place(p), place(p + 1), less); });
  for (std::size_t width = 1; width < parts; width *= 2)
    parallel_for(parts / (2 * width), [&](std::size_t pair) {
      const std::size_t first = 2 * width * pair;
      std::inplace_merge(place(first), place(first + width), place(first + 2 * width), less);
    });
}

}  // namespace asterism::internal
