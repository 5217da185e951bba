// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/thread_limit.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
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
  const std::size_t all = thread_count();
  CHECK(all == processor_count());
  {
    const thread_limit one(1);
    CHECK(thread_count() == 1);
    const thread_limit none(0);
    CHECK(thread_count() == 1);  // a limit of 0 changes nothing
    const thread_limit more(4, 4);
    CHECK(thread_count() == 1);
    std::thread([all] { CHECK(thread_count() == all); }).join();
  }
  CHECK(thread_count() == all);
  {
    const thread_limit two(2);
    CHECK(thread_count() <= 2);
    const thread_limit four(4, 4);
    CHECK(thread_count() <= 2);
  }
}

TEST_CASE("every turn of loops in loops is done once", "[threads]") {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const thread_limit limit(threads, threads);
    for (std::size_t count = 0; count < 100; count += 7) {
      // Each turn has a place of its own, as two threads may do both halves at the same time.
      using halves = std::array<int, 2>;
      std::vector<std::vector<halves>> done(count, std::vector<halves>(count, halves{0, 0}));
      parallel_for(count, [&](std::size_t i) {
        parallel_for(count, [&](std::size_t j) {
          parallel_for(2, [&](std::size_t half) { ++done[i][j][half]; });
        });
      });
      CHECK(done == std::vector<std::vector<halves>>(count, std::vector<halves>(count, {1, 1})));
    }
  }
}

TEST_CASE("loops of several threads go on at the same time", "[threads]") {
  std::vector<std::size_t> sums(4);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < sums.size(); ++t)
    threads.emplace_back([&, t] {
      const thread_limit limit(3, 3);
      for (int turn = 0; turn < 50; ++turn) {
        std::vector<std::size_t> parts(64);
        parallel_for(parts.size(), [&](std::size_t i) { parts[i] = i; });
        sums[t] += std::accumulate(parts.begin(), parts.end(), std::size_t{0});
      }
    });
  for (std::thread& t : threads) t.join();
  CHECK(sums == std::vector<std::size_t>(4, 50 * 2016));
}

TEST_CASE("a limit that is set inside a loop holds for the loops in it", "[threads]") {
  const thread_limit four(4, 4);
  std::vector<std::size_t> inside(16), ids(16);
  parallel_for(inside.size(), [&](std::size_t i) {
    const thread_limit one(1);
    inside[i] = thread_count();
    const auto self = std::this_thread::get_id();
    parallel_for(20, [&](std::size_t) { ids[i] += std::this_thread::get_id() == self ? 1 : 0; });
  });
  CHECK(inside == std::vector<std::size_t>(16, 1));
  CHECK(ids == std::vector<std::size_t>(16, 20));
}

TEST_CASE("other threads round to nearest, whatever the mode of the caller", "[threads]") {
  const thread_limit four(4, 4);
  std::vector<double> sums(200, 1);
  const auto caller = std::this_thread::get_id();
  const floating_point_scope upward(rounding::upward);
  parallel_for(sums.size(), [&](std::size_t i) {
    volatile double little = 0x1p-60;
    for (volatile int spent = 0; spent < 1000;) spent = spent + 1;
    if (std::this_thread::get_id() != caller) sums[i] = 1 + little;
  });
  CHECK(sums == std::vector<double>(sums.size(), 1));
}

TEST_CASE("an exception leaves a loop", "[threads]") {
  for (const std::size_t threads : {1, 4}) {
    const thread_limit limit(threads, threads);
    const auto fail_once = [](std::size_t i) {
      if (i == 3) throw std::runtime_error("no");
    };
    CHECK_THROWS_AS(parallel_for(10, fail_once), std::runtime_error);
    CHECK_THROWS_AS(parallel_for(10, [&](std::size_t) { parallel_for(10, fail_once); }),
                    std::runtime_error);
    std::size_t done = 0;
    parallel_for(1, [&](std::size_t) { ++done; });
    CHECK(done == 1);
  }
}

TEST_CASE("sorting gives one order for any number of threads", "[threads]") {
  std::vector<unsigned> items(20000);
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i] = static_cast<unsigned>(i * 2654435761U % 1000003U);
  std::vector<unsigned> expected = items;
  std::sort(expected.begin(), expected.end());
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const thread_limit limit(threads, threads);
    std::vector<unsigned> sorted = items;
    parallel_sort(sorted.begin(), sorted.end());
    CHECK(sorted == expected);
  }
}
