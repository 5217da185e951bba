// SPDX-License-Identifier: MIT
//
// A parallel loop whose turns change one number: a data race. In a build with the thread sanitizer
// the sanitizer's report is this program's success.
#include <cstddef>
#include <cstdio>

#include "asterism/mesh/support/parallel.hpp"

int main() {
  constexpr std::size_t threads = 4, turns = 4000;
  const asterism::internal::thread_limit exact(threads, threads);
  std::size_t total = 0;
  asterism::internal::parallel_chunks(turns, 1,
                                      [&](std::size_t, std::size_t begin, std::size_t end) {
                                        for (volatile std::size_t spent = 0; spent < 1000;)
                                          spent = spent + 1;
                                        total += end - begin;
                                      });
  std::printf("%zu of %zu\n", total, turns);
  return 0;
}
