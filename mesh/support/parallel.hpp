// SPDX-License-Identifier: MIT
//
// Splits work into chunks of fixed size, done by as many threads as the caller may have.
// The work of a chunk must depend on its bounds alone; results are put together chunk by chunk,
// so that the outcome is the same for every number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "asterism/mesh/support/parallel_for.hpp"

namespace asterism::internal {

inline std::size_t chunk_count(std::size_t count, std::size_t chunk) {
  return (count + chunk - 1) / chunk;
}

// Calls work(chunk, begin, end) for each chunk of [0, count).
template <class Work>
void parallel_chunks(std::size_t count, std::size_t chunk, const Work& work) {
  const std::size_t chunks = chunk_count(count, chunk);
  if (chunks == 1) {
    work(std::size_t{0}, std::size_t{0}, count);
    return;
  }
  parallel_for(chunks,
               [&](std::size_t i) { work(i, i * chunk, std::min(count, (i + 1) * chunk)); });
}

// Returns what work(begin, end) returns for each chunk of [0, count), in order. Results of several
// chunks share lines of the cache, so that each is written once, when its chunk is done.
template <class Result, class Work>
std::vector<Result> map_chunks(std::size_t count, std::size_t chunk, const Work& work) {
  std::vector<Result> results(chunk_count(count, chunk));
  parallel_chunks(count, chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    results[i] = work(begin, end);
  });
  return results;
}

// Writes to each page of new memory, in several threads: the system clears a page at its first
// access, and one thread alone would wait for all of them. The bytes must not be in use.
inline void access_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = 4096, parts = 16;
  const std::size_t at_once =
      std::clamp(bytes / parts, std::size_t{1} << 18U, std::size_t{1} << 21U);
  auto* const first = static_cast<volatile unsigned char*>(memory);
  parallel_chunks(bytes, at_once, [first](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += page) first[i] = 0;
  });
}

// Reserves room for this many elements, and accesses the memory beyond the present ones in several
// threads.
template <class List>
void reserve_in_threads(List& list, std::size_t size) {
  if (size <= list.size()) return;
  list.reserve(size);
  access_pages(list.data() + list.size(), sizeof(list[0]) * (size - list.size()));
}

// Resizes a list. Several threads access the memory of the new elements first.
template <class List>
void resize_in_threads(List& list, std::size_t size) {
  reserve_in_threads(list, size);
  list.resize(size);
}

// Returns a copy of a list. Several threads access its memory first.
template <class List>
List copy_in_threads(const List& list) {
  List copy;
  reserve_in_threads(copy, list.size());
  copy.assign(list.begin(), list.end());
  return copy;
}

// Returns the concatenation of what append(begin, end, out) adds to `out` for each chunk, in order.
template <class Item, class Append>
std::vector<Item> collect_chunks(std::size_t count, std::size_t chunk, const Append& append) {
  auto parts = map_chunks<std::vector<Item>>(count, chunk, [&](std::size_t begin, std::size_t end) {
    std::vector<Item> found;
    append(begin, end, found);
    return found;
  });
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<Item> all;
  reserve_in_threads(all, total);
  for (auto& part : parts)
    all.insert(all.end(), std::make_move_iterator(part.begin()),
               std::make_move_iterator(part.end()));
  return all;
}

}  // namespace asterism::internal
