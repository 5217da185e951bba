// SPDX-License-Identifier: MIT
//
// Numbers the items of a list that are present, where others are gone.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

// Numbers of the items of a list that are present.
struct present_numbers {
  static constexpr vertex_index gone = ~vertex_index{0};

  // The number of each item: from 0 on, in the order of the items; `gone` where one is not present.
  std::vector<vertex_index> of;
  std::size_t count = 0;  // of items that are present
};

// Numbers items 0 to count - 1, in several threads; is_present(item) may be called from any.
template <class Test>
present_numbers number_present(std::size_t count, const Test& is_present) {
  constexpr std::size_t chunk = 8192;  // items
  present_numbers numbers;
  auto next = map_chunks<std::size_t>(count, chunk, [&](std::size_t begin, std::size_t end) {
    std::size_t present = 0;
    for (std::size_t k = begin; k < end; ++k) present += is_present(k) ? 1 : 0;
    return present;
  });
  for (std::size_t& first : next) numbers.count += std::exchange(first, numbers.count);
  resize_in_threads(numbers.of, count);
  parallel_chunks(count, chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    std::size_t number = next[i];
    for (std::size_t k = begin; k < end; ++k)
      numbers.of[k] = is_present(k) ? static_cast<vertex_index>(number++) : present_numbers::gone;
  });
  return numbers;
}

}  // namespace asterism::internal
