// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/thread_limit.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "asterism/mesh/support/parallel.hpp"

using namespace asterism::internal;

TEST_CASE("one thread runs a loop in order, in the caller", "[threads]") {
  const thread_limit one(1);
  CHECK(thread_count() == 1);
  std::vector<std::size_t> seen;
  bool is_caller = true;
  parallel_for(1000, [&, caller = std::this_thread::get_id()](std::size_t i) {
    is_caller = is_caller && std::this_thread::get_id() == caller;
    seen.push_back(i);
  });
  std::vector<std::size_t> expected(1000);
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  CHECK(is_caller);
  CHECK(seen == expected);
}

TEST_CASE("a limit ends with its object", "[threads]") {
  CHECK(!thread_limit::is_one());
  {
    const thread_limit one(1);
    CHECK(thread_limit::is_one());
    const thread_limit none(0);
    CHECK(thread_limit::is_one());  // a limit of 0 changes nothing
    std::thread([] { CHECK(!thread_limit::is_one()); }).join();
  }
  CHECK(!thread_limit::is_one());
  {
    const thread_limit two(2);
    CHECK(!thread_limit::is_one());
    CHECK(thread_count() <= 2);
  }
}

TEST_CASE("an exception leaves a loop of one thread", "[threads]") {
  const thread_limit one(1);
  CHECK_THROWS_AS(parallel_for(10,
                               [](std::size_t i) {
                                 if (i == 3) throw std::runtime_error("no");
                               }),
                  std::runtime_error);
}

TEST_CASE("sorting gives one order for any number of threads", "[threads]") {
  std::vector<unsigned> items(20000);
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i] = static_cast<unsigned>(i * 2654435761U % 1000003U);
  std::vector<unsigned> expected = items;
  std::sort(expected.begin(), expected.end());
  for (const std::size_t threads : {1, 2, 3}) {
    const thread_limit limit(threads);
    std::vector<unsigned> sorted = items;
    parallel_sort(sorted.begin(), sorted.end());
    CHECK(sorted == expected);
  }
}
