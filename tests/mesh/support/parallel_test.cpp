// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/parallel.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/support/number_present.hpp"
#include "asterism/mesh/support/thread_limit.hpp"

using namespace asterism::internal;

TEST_CASE("a list resized in threads keeps its elements, and has none of what was in its memory") {
  constexpr std::size_t before = 1000, after = 3'000'000;  // of several chunks of pages
  std::vector<int> list(before);
  std::iota(list.begin(), list.end(), 1);
  resize_in_threads(list, after);
  REQUIRE(list.size() == after);
  for (std::size_t i = 0; i < before; ++i) REQUIRE(list[i] == static_cast<int>(i) + 1);
  for (std::size_t i = before; i < after; ++i) REQUIRE(list[i] == 0);
  resize_in_threads(list, before / 2);
  CHECK(list.size() == before / 2);
  std::string text = "kept";
  resize_in_threads(text, after);
  CHECK(text.substr(0, 5) == std::string("kept\0", 5));
  CHECK(text.find_first_not_of('\0', 4) == std::string::npos);
}

TEST_CASE("a list copied in threads is the same list") {
  for (const std::size_t size : {0U, 1U, 3'000'000U}) {
    std::vector<int> list(size);
    std::iota(list.begin(), list.end(), 1);
    CHECK(copy_in_threads(list) == list);
  }
}

TEST_CASE("results of chunks are in the order of the chunks, for any number of threads") {
  constexpr std::size_t count = 1001, chunk = 10;
  using range = std::pair<std::size_t, std::size_t>;
  const auto bounds = [](std::size_t begin, std::size_t end) { return range{begin, end}; };
  for (const unsigned threads : {1U, 2U, 3U, 7U}) {
    const thread_limit limit(threads);
    const auto results = map_chunks<range>(count, chunk, bounds);
    REQUIRE(results.size() == chunk_count(count, chunk));
    for (std::size_t i = 0; i < results.size(); ++i)
      CHECK(results[i] == range{i * chunk, std::min(count, (i + 1) * chunk)});
  }
  CHECK(map_chunks<range>(0, chunk, bounds).empty());
}

TEST_CASE("items that are present are numbered in their order, for any number of threads") {
  constexpr std::size_t count = 100'000;
  const auto is_present = [](std::size_t i) { return i % 5 != 2 && i / 10'000 != 3; };
  for (const std::size_t threads : {1U, 2U, 7U}) {
    const thread_limit limit(threads);
    const present_numbers numbers = number_present(count, is_present);
    REQUIRE(numbers.of.size() == count);
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i)
      REQUIRE(numbers.of[i] == (is_present(i) ? next++ : present_numbers::gone));
    CHECK(numbers.count == next);
  }
  CHECK(number_present(0, is_present).count == 0);
}

TEST_CASE("what chunks append is joined in their order, also what can only be moved") {
  constexpr std::size_t count = 10'000, chunk = 7;
  const auto found = collect_chunks<std::unique_ptr<std::size_t>>(
      count, chunk, [](std::size_t begin, std::size_t end, auto& out) {
        for (std::size_t i = begin; i < end; ++i)
          if (i % 3 != 0) out.push_back(std::make_unique<std::size_t>(i));
      });
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (i % 3 != 0) REQUIRE(*found.at(next++) == i);
  CHECK(next == found.size());
  CHECK(collect_chunks<int>(0, chunk, [](std::size_t, std::size_t, auto&) {}).empty());
}
