// SPDX-License-Identifier: MIT
#include "asterism/apps/run/freed_memory.hpp"

#include <cstdint>
#include <cstdlib>  // defines __GLIBC__ where it is the C library

#include "asterism/mesh/support/large_page_allocator.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace asterism::apps {

namespace {

// Sets the size in bytes of the smallest blocks that are given back to the system when they are
// freed, and the most that is kept of what is free at the end of the heap.
void give_back_from([[maybe_unused]] int bytes, [[maybe_unused]] int at_end) {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, bytes);
  mallopt(M_TRIM_THRESHOLD, at_end);
#endif
}

// Places the next 96 megabytes of the heap in large pages of the system. Each of these becomes
// resident at its first access, in place of 512 small ones. The header of the first block lies in
// the page before, since nothing of a large page may have been accessed before it is requested.
// Without effect where the C library takes its blocks elsewhere, or the system has no such pages.
void begin_large_pages() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t small = 4096, large = internal::large_page, pages = 48 * large;
  constexpr std::size_t size = small + pages;  // up to the header after it
  // Takes this block from the heap although it is large, and keeps it there.
  give_back_from(size + small, 2 * size);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t start = (end + small + large - 1) / large * large;
  sbrk(static_cast<std::intptr_t>(start - small - end));
  auto* const block = static_cast<char*>(std::malloc(size));
  const auto from = reinterpret_cast<std::uintptr_t>(block);
  if (block != nullptr && from <= start && start + pages <= from + size)
    madvise(block + (start - from), pages, MADV_HUGEPAGE);
  std::free(block);
#endif
}

}  // namespace

void give_back_large_blocks() {
  constexpr int large = 128 << 10;  // where the library begins by itself
  give_back_from(large, large);
}

void keep_freed_blocks() {
  constexpr int large = 32 << 20, at_end = 256 << 20;
  begin_large_pages();
  give_back_from(large, at_end);
}

void give_back_small_blocks() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace asterism::apps
