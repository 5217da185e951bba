// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/large_page_allocator.hpp"

#include <array>
#include <boost/container/deque.hpp>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>

namespace asterism::internal {
namespace {

template <class T>
bool is_on_page(const T* block) {
  return reinterpret_cast<std::uintptr_t>(block) % large_page == 0;
}

TEST_CASE("Blocks of a large page begin on one, those of half of one and less need not") {
  large_page_allocator<double> allocator;
  for (const std::size_t bytes : {within_large_page, large_page / 2 + sizeof(double)}) {
    double* const block = allocator.allocate(bytes / sizeof(double));
    CHECK(is_on_page(block));
    block[bytes / sizeof(double) - 1] = 1;
    allocator.deallocate(block, bytes / sizeof(double));
  }
  double* const small = allocator.allocate(1);
  *small = 1;
  allocator.deallocate(small, 1);
}

TEST_CASE("A deque over large pages grows, shrinks and keeps what it holds") {
  using element = std::array<std::size_t, 35>;  // as large as the star of a fill
  using blocks =
      boost::container::deque_options_t<boost::container::block_bytes<within_large_page>>;
  boost::container::deque<element, large_page_allocator<element>, blocks> all;
  constexpr std::size_t in_a_page = within_large_page / sizeof(element), count = 3 * in_a_page + 1;
  all.resize(count);
  for (std::size_t i = 0; i < count; ++i) all[i][0] = i;
  all.resize(count - in_a_page);
  all.resize(count);
  for (std::size_t page = 0; page < 3; ++page) CHECK(is_on_page(&all[page * in_a_page]));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count - in_a_page; ++i) kept += all[i][0] == i ? 1 : 0;
  CHECK(kept == count - in_a_page);
}

}  // namespace
}  // namespace asterism::internal
