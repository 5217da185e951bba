// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

namespace asterism::internal {

// Resizes a list whose elements will all be overwritten. Where it has to grow it drops its elements
// first, in place of copying them, and reserves room for the number expected, and an eighth more:
// splits add elements soon, and the next cut often joins a somewhat larger mesh. One thread alone
// would copy the list, and access the pages of its new memory for the first time.
template <class List>
void resize_to_overwrite(List& list, std::size_t size, std::size_t expected) {
  constexpr std::size_t part = 8;
  if (list.capacity() < size) {
    const std::size_t most = std::max(size, expected);
    list = List();
    list.reserve(most + most / part);
  }
  list.resize(size);
}

}  // namespace asterism::internal
