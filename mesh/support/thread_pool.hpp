// SPDX-License-Identifier: MIT
//
// Threads that wait for loops. A thread that begins a loop works on it itself; threads that have
// nothing to do join it, up to the limit of the thread that began the outermost loop around it. A
// loop inside a loop has the same threads. Whoever has to wait until others have finished a loop
// joins loops inside it in the meantime.
#pragma once

#include <cstddef>

namespace asterism::internal {

// Does the work with the numbers begin to end - 1.
using loop_part = void (*)(const void* work, std::size_t begin, std::size_t end);

// Calls part(work, begin, end) for parts of [0, count), in any order and at the same time, and
// returns when all have been done. If some of them throw, parts that have not begun are left out,
// and an exception of one of them leaves the loop. Other threads than the caller's round to
// nearest: work that needs another mode sets it itself.
void run_loop(std::size_t count, loop_part part, const void* work);

}  // namespace asterism::internal
