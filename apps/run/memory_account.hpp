// SPDX-License-Identifier: MIT
//
// Counts what the program holds in memory, and refuses to hold more than it may.
#pragma once

#include <cstddef>

namespace asterism::apps {

// From its construction to its end, `operator new` counts what it gives and what comes back, and
// throws std::bad_alloc for what would take the count beyond the limit. Without one, `operator new`
// costs what it always does. There can be one at a time.
//
// Counts what the C++ code of the program asks for. Beside it are the program's files, which the
// limit takes into account as they become resident, stacks of threads, and blocks that libraries of
// C ask for. What is resident follows what is held where large blocks are given back
// as soon as they are free (apps/run/freed_memory.hpp).
class memory_account {
 public:
  // `bytes` is the limit on all that is resident, the program included. It may be passed by a
  // twentieth: whoever looks at resident() and ends in time is not to be disturbed while it
  // concludes.
  explicit memory_account(double bytes);
  ~memory_account();
  memory_account(const memory_account&) = delete;
  memory_account& operator=(const memory_account&) = delete;

  // Returns what is resident, in bytes; 0 where the system does not tell.
  static double resident();
};

}  // namespace asterism::apps
