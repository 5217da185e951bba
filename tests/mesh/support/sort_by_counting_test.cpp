// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/sort_by_counting.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <numeric>
#include <vector>

#include "asterism/mesh/support/thread_limit.hpp"

using namespace asterism::internal;

namespace {

std::size_t group_of(std::size_t item) { return item * 2654435761U % 1000003U % 257; }

}  // namespace

TEST_CASE("counting sorts as comparing does, for any number of threads", "[threads]") {
  constexpr std::size_t groups = 300;  // the last ones are empty
  for (const std::size_t count : {0, 1, 1000, 100000}) {
    std::vector<std::size_t> expected(count);
    std::iota(expected.begin(), expected.end(), std::size_t{0});
    std::stable_sort(expected.begin(), expected.end(),
                     [](std::size_t a, std::size_t b) { return group_of(a) < group_of(b); });
    for (const std::size_t threads : {1, 2, 3, 7}) {
      const thread_limit limit(threads);
      std::vector<std::size_t> sorted(count);
      const auto begins = sort_by_counting(count, groups, group_of,
                                           [&](std::size_t at, std::size_t i) { sorted[at] = i; });
      CHECK(sorted == expected);
      REQUIRE(begins.size() == groups + 1);
      CHECK(begins.front() == 0);
      CHECK(begins.back() == count);
      bool is_grouped = std::is_sorted(begins.begin(), begins.end());
      for (std::size_t g = 0; is_grouped && g < groups; ++g)
        for (std::size_t i = begins[g]; i < begins[g + 1]; ++i)
          is_grouped = is_grouped && group_of(sorted[i]) == g;
      CHECK(is_grouped);
    }
  }
}
