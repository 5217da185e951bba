// SPDX-License-Identifier: MIT
//
// Splits work into chunks of fixed size, done by as many threads as the caller may have.
// The work of a chunk must depend on its bounds alone; results are put together chunk by chunk,
// so that the outcome is the same for every number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
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

// Returns the concatenation of what append(begin, end, out) adds to `out` for each chunk, in order.
template <class Item, class Append>
std::vector<Item> collect_chunks(std::size_t count, std::size_t chunk, const Append& append) {
  std::vector<std::vector<Item>> parts(chunk_count(count, chunk));
  parallel_chunks(count, chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    append(begin, end, parts[i]);
  });
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<Item> all;
  all.reserve(total);
  for (auto& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
  return all;
}

}  // namespace asterism::internal
