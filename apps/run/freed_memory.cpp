// SPDX-License-Identifier: MIT
#include "asterism/apps/run/freed_memory.hpp"

#include <atomic>
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

// A global variable, since `operator new` reads it (memory_account.cpp).
constinit std::atomic<bool> are_kept = false;

// Places the next small blocks in a large page of the system, which becomes resident at one access
// in place of 512. The header of the first block lies in the page before, since nothing of a large
// page may have been accessed before it is requested. Without effect where the C library takes its
// blocks elsewhere, or the system has no such pages.
void begin_large_page() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t small = 4096, large = internal::large_page;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t start = (end + small + large - 1) / large * large;
  sbrk(static_cast<std::intptr_t>(start - small - end));
  constexpr std::size_t size = small + large;  // up to the header after it
  auto* const block = static_cast<char*>(std::malloc(size));
  const auto from = reinterpret_cast<std::uintptr_t>(block);
  if (block != nullptr && from <= start && start + large <= from + size)
    madvise(block + (start - from), large, MADV_HUGEPAGE);
  std::free(block);
#endif
}

}  // namespace

void give_back_large_blocks() {
#ifdef __GLIBC__
  constexpr int large = 128 << 10, most = 1 << 16;  // bytes, blocks: what the library begins with
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
  mallopt(M_MMAP_MAX, most);
#endif
  are_kept = false;
}

void keep_freed_blocks() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);  // never
#endif
  are_kept = true;
  begin_large_page();
}

bool keeps_freed_blocks() { return are_kept.load(std::memory_order_relaxed); }

void give_back_small_blocks() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace asterism::apps
