// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

// Resizes a list whose elements will all be overwritten. Where it has to grow it drops its elements
// first, in place of copying them, and reserves room for 1.4 times the number expected: splits of
// the second fit make a third more nodes than are wanted for a while.
template <class List>
void resize_to_overwrite(List& list, std::size_t size, std::size_t expected) {
  constexpr double times = 1.4;
  if (list.capacity() < size) {
    list = List();
    list.reserve(std::max(size, static_cast<std::size_t>(times * static_cast<double>(expected))));
  }
  resize_in_threads(list, size);
}

}  // namespace asterism::internal
