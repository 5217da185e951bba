// SPDX-License-Identifier: MIT
//
// Counts work from several threads. The sum does not depend on their order.
#pragma once

#include <atomic>
#include <cstddef>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace asterism::internal {

// True if the process certainly has one thread.
inline bool is_single_threaded() {
#if __has_include(<sys/single_threaded.h>)
  return __libc_single_threaded != 0;
#else
  return false;
#endif
}

// A count that several threads add to. A copy starts from the present count, and counts separately.
class shared_count {
 public:
  shared_count() = default;
  shared_count(const shared_count& other) : count_(other.count_.load(std::memory_order_relaxed)) {}
  shared_count& operator=(const shared_count& other) {
    count_.store(other.count_.load(std::memory_order_relaxed), std::memory_order_relaxed);
    return *this;
  }
  ~shared_count() = default;

  void add(std::size_t more) {
    // A process with one thread needs no locked addition, which takes as long as visiting a face.
    if (is_single_threaded())
      count_.store(count_.load(std::memory_order_relaxed) + more, std::memory_order_relaxed);
    else if (more > 0)
      count_.fetch_add(more, std::memory_order_relaxed);
  }
  // Returns the count and resets it to 0.
  std::size_t take() {
    // Most counts of a search are 0, and an exchange takes as long as a locked addition.
    if (count_.load(std::memory_order_relaxed) == 0) return 0;
    return count_.exchange(0, std::memory_order_relaxed);
  }

 private:
  std::atomic<std::size_t> count_{0};
};

}  // namespace asterism::internal
