// SPDX-License-Identifier: MIT
//
// Allocates blocks that fill a large page of the system, for data read in random order, as the
// stars of a fill are: at ten million triangles every star is on another page, and most of the time
// would go into finding pages. Only aligns the blocks; the program's operator new requests the
// large pages (apps/run/memory_account.cpp).
#pragma once

#include <cstddef>
#include <new>

namespace asterism::internal {

inline constexpr std::size_t large_page = std::size_t{2} << 20;
// Largest size of a block of one page: allocators keep some bytes beside each block, and a larger
// block would occupy two pages.
inline constexpr std::size_t within_large_page = large_page - 64;

template <class T>
struct large_page_allocator {
  using value_type = T;

  large_page_allocator() = default;
  template <class U>
  explicit(false) large_page_allocator(const large_page_allocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = bytes_of(count);
    return static_cast<T*>(fills_page(bytes) ? ::operator new (bytes, std::align_val_t{large_page})
                                             : ::operator new(bytes));
  }
  void deallocate(T* block, std::size_t count) {
    if (fills_page(bytes_of(count)))
      ::operator delete (block, std::align_val_t{large_page});
    else
      ::operator delete(block);
  }

  template <class U>
  bool operator==(const large_page_allocator<U>& /*other*/) const {
    return true;
  }

 private:
  // Allocates for pointers, too: a deque allocates the list of its blocks here.
  static constexpr std::size_t bytes_of(std::size_t count) {
    return count * sizeof(T);  // NOLINT(bugprone-sizeof-expression)
  }
  static constexpr bool fills_page(std::size_t bytes) { return bytes > large_page / 2; }
};

}  // namespace asterism::internal
