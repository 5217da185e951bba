// SPDX-License-Identifier: MIT
//
// Limits the number of threads.
#pragma once

#include <cstddef>

namespace asterism::internal {

// Returns the number of processors that the process may use, and 1 in a build without threads.
std::size_t processor_count();

// Returns the number of threads that a loop of the calling thread may have. No result may depend on
// it.
std::size_t thread_count();

// Limits the number of threads of loops that the calling thread begins during the lifetime of the
// object. 0 sets no limit: there is one thread a processor. Objects of one thread end in the
// reverse order of their beginnings.
class thread_limit {
 public:
  // There are no more threads than `most`, which tests raise above the number of processors.
  explicit thread_limit(std::size_t threads, std::size_t most = processor_count());
  ~thread_limit();
  thread_limit(const thread_limit&) = delete;
  thread_limit& operator=(const thread_limit&) = delete;

 private:
  std::size_t before_;  // 0 without a limit
};

}  // namespace asterism::internal
