// SPDX-License-Identifier: MIT
//
// Wraps oneTBB's parallel_for and parallel_sort. One thread alone works without oneTBB. The order
// of a loop is declared to the thread sanitizer: it begins after everything that its caller did
// before, and ends before the caller goes on. oneTBB as packaged is not compiled with the
// sanitizer, which would therefore take every value handed to a loop, or back, for a race. Races
// between two iterations of one loop are still found. Without the sanitizer this is exactly
// parallel_for.
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <functional>

#include "asterism/mesh/support/thread_limit.hpp"

#if defined(__SANITIZE_THREAD__)
#define ASTERISM_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define ASTERISM_THREAD_SANITIZER
#endif
#endif

#ifdef ASTERISM_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace asterism::internal {

#ifdef ASTERISM_THREAD_SANITIZER

template <class Body>
class declared_loop {
 public:
  explicit declared_loop(const Body& body) : body_(body) {}

  void run(std::size_t count) {
    __tsan_release(&begin_);
    tbb::parallel_for(std::size_t{0}, count, [this](std::size_t i) { turn(this, i); });
    __tsan_acquire(&end_);
  }

 private:
  [[gnu::noinline]] static void turn(declared_loop* loop, std::size_t i) {
    __tsan_acquire(&loop->begin_);
    loop->body_(i);
    __tsan_release(&loop->end_);
  }

  const Body& body_;
  char begin_ = 0, end_ = 0;  // their addresses name the two orders
};

template <class Body>
void loop_by_threads(std::size_t count, const Body& body) {
  declared_loop<Body>(body).run(count);
}

#else

template <class Body>
void loop_by_threads(std::size_t count, const Body& body) {
  tbb::parallel_for(std::size_t{0}, count, body);
}

#endif

// Calls body(i) for each i below count, by as many threads as the caller's oneTBB arena has.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  if (!thread_limit::is_one()) return loop_by_threads(count, body);
  for (std::size_t i = 0; i < count; ++i) body(i);
}

// Sorts by as many threads. No two items may be equivalent, as these have any order.
template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, const Less& less = {}) {
  if (thread_limit::is_one())
    std::sort(begin, end, less);
  else
    tbb::parallel_sort(begin, end, less);
}

// Returns the number of threads that the caller's arena may have. No result may depend on it.
inline std::size_t thread_count() {
  if (thread_limit::is_one()) return 1;
  const auto in_arena = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  return std::min(in_arena,
                  tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace asterism::internal
