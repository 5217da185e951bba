// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

// Writes to each page of new memory, in several threads: the system clears a page at its first
// access, and one thread alone would wait for all of them. The bytes must not be in use.
inline void access_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = 4096, at_once = std::size_t{1} << 21U;
  auto* const first = static_cast<volatile unsigned char*>(memory);
  parallel_chunks(bytes, at_once, [first](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += page) first[i] = 0;
  });
}

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
  if (list.size() < size)
    access_pages(list.data() + list.size(), sizeof(list[0]) * (size - list.size()));
  list.resize(size);
}

}  // namespace asterism::internal
