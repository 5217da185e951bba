// SPDX-License-Identifier: MIT
//
// Limits the number of threads.
#pragma once

#include <tbb/global_control.h>

#include <cstddef>
#include <optional>

namespace asterism::internal {

// Limits the number of threads of loops that the calling thread begins during the lifetime of the
// object. 0 sets no limit: there is one thread a processor. A limit of one is kept here and not by
// oneTBB, whose start takes several hundred microseconds: it loads its allocator, reads files about
// the machine and begins a thread. Objects of one thread end in the reverse order of their
// beginnings.
class thread_limit {
 public:
  explicit thread_limit(std::size_t threads) : was_one_(one()) {
    if (threads == 1)
      one() = true;
    else if (threads > 1)
      limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  ~thread_limit() { one() = was_one_; }
  thread_limit(const thread_limit&) = delete;
  thread_limit& operator=(const thread_limit&) = delete;

  // Returns whether loops of the calling thread are limited to itself.
  static bool is_one() { return one(); }

 private:
  static bool& one() {
    // Keeps one flag a thread, as oneTBB keeps its arenas, since loops read it at any depth of
    // calls.
    thread_local bool is_one = false;
    return is_one;
  }

  bool was_one_;
  std::optional<tbb::global_control> limit_;
};

}  // namespace asterism::internal
