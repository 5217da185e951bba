// SPDX-License-Identifier: MIT
//
// Counts the memory that the program allocates, and refuses allocations beyond a limit.
#pragma once

#include <cstddef>

namespace asterism::apps {

// During its lifetime `operator new` counts allocated and freed bytes, and throws std::bad_alloc
// for what would take the count beyond the limit. Without an account `operator new` has no extra
// cost. There can be one at a time.
//
// Counts allocations of the program's C++ code. Not counted are the program's files, which the
// limit takes into account as they become resident, stacks of threads, and allocations of C
// libraries. Resident memory follows the count if large blocks are given back as soon as they are
// free (apps/run/freed_memory.hpp).
class memory_account {
 public:
  // Takes the limit, in bytes, on all resident memory, the program included. Up to 5 % over
  // the limit is tolerated, so that a caller that polls resident() can conclude and end in
  // time.
  explicit memory_account(double bytes);
  ~memory_account();
  memory_account(const memory_account&) = delete;
  memory_account& operator=(const memory_account&) = delete;

  // Returns the resident memory in bytes; 0 where the system does not report it.
  static double resident();
};

}  // namespace asterism::apps
