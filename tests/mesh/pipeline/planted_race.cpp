// SPDX-License-Identifier: MIT
//
// A parallel loop whose turns change one number: a data race. In a build with the thread sanitizer
// the sanitizer's report is this program's success, so that declared orders and suppressions are
// known not to hide races.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <cstdio>

#include "asterism/mesh/support/parallel.hpp"

int main() {
  constexpr std::size_t threads = 4, turns = 4000;
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
  std::size_t total = 0;
  tbb::task_arena(static_cast<int>(threads)).execute([&] {
    asterism::parallel_chunks(turns, 1, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (volatile std::size_t spent = 0; spent < 1000;) spent = spent + 1;
      total += end - begin;
    });
  });
  std::printf("%zu of %zu\n", total, turns);
  return 0;
}
