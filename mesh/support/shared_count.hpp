// SPDX-License-Identifier: MIT
//
// Counts work from several threads. The sum does not depend on their order.
#pragma once

#include <algorithm>
#include <array>
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

// A count that several threads add to. Each thread adds to a part of its own, in a cache line of
// its own: additions of two threads to one number take longer than the work that they count. The
// last part is shared by all threads for which there is none. A copy starts from the present count,
// and counts separately. No thread may add while another one copies or takes the count.
class shared_count {
 public:
  shared_count() = default;
  shared_count(const shared_count& other) { *this = other; }
  shared_count& operator=(const shared_count& other) {
    for (std::size_t i = 0; i < parts; ++i)
      parts_[i].count.store(other.parts_[i].count.load(std::memory_order_relaxed),
                            std::memory_order_relaxed);
    return *this;
  }
  ~shared_count() = default;

  void add(std::size_t more) {
    // A process with one thread is spared the look-up of its part.
    const std::size_t own = is_single_threaded() ? 0 : part_of_thread();
    std::atomic<std::size_t>& count = parts_[own].count;
    // An addition to a part of one thread needs no lock, which takes as long as visiting a face.
    if (own < last)
      count.store(count.load(std::memory_order_relaxed) + more, std::memory_order_relaxed);
    else
      count.fetch_add(more, std::memory_order_relaxed);
  }
  // Returns the count and resets it to 0.
  std::size_t take() {
    std::size_t sum = 0;
    for (part& p : parts_) {
      // Most counts of a search are 0, and an exchange takes as long as a locked addition.
      if (p.count.load(std::memory_order_relaxed) != 0)
        sum += p.count.exchange(0, std::memory_order_relaxed);
    }
    return sum;
  }

 private:
  static constexpr std::size_t parts = 8, last = parts - 1;
  static constexpr std::size_t cache_line = 64;

  struct alignas(cache_line) part {
    std::atomic<std::size_t> count{0};
  };

  static std::size_t part_of_thread() {
    static std::atomic<std::size_t> threads{0};
    thread_local const std::size_t own =
        std::min(last, threads.fetch_add(1, std::memory_order_relaxed));
    return own;
  }

  std::array<part, parts> parts_;
};

}  // namespace asterism::internal
