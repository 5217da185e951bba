// SPDX-License-Identifier: MIT
//
// Stands in for what the mesher uses of oneTBB where there is one thread: builds with
// ASTERISM_THREADS off, and WebAssembly without shared memory. What the mesher gives does not
// depend on the number of threads (mesh/support/parallel.hpp).
#pragma once

#include <algorithm>
#include <cstddef>

namespace tbb {

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  for (Index i = first; i < last; ++i) body(i);
}

template <class Iterator>
void parallel_sort(Iterator first, Iterator last) {
  std::sort(first, last);
}
template <class Iterator, class Compare>
void parallel_sort(Iterator first, Iterator last, const Compare& before) {
  std::sort(first, last, before);
}

namespace this_task_arena {
inline int max_concurrency() { return 1; }
}  // namespace this_task_arena

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
  static std::size_t active_value(parameter) { return 1; }
};

}  // namespace tbb
