// SPDX-License-Identifier: MIT
//
// Counts work from several threads at the same time.
#include "asterism/mesh/support/shared_count.hpp"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using namespace asterism::internal;

TEST_CASE("additions of more threads than a count has parts are all in its sum", "[threads]") {
  constexpr std::size_t threads = 20, times = 10000;
  shared_count count;
  count.add(5);
  std::vector<std::thread> all;
  for (std::size_t i = 0; i < threads; ++i)
    all.emplace_back([&count, i] {
      for (std::size_t k = 0; k < times; ++k) count.add(i);
    });
  for (std::thread& thread : all) thread.join();
  shared_count copy = count;
  const std::size_t sum = 5 + times * threads * (threads - 1) / 2;
  CHECK(count.take() == sum);
  CHECK(count.take() == 0);
  copy.add(1);
  CHECK(copy.take() == sum + 1);
  count.add(2);
  copy = count;
  CHECK(copy.take() == 2);
  CHECK(count.take() == 2);
}
