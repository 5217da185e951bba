// SPDX-License-Identifier: MIT
#include "asterism/apps/run/freed_memory.hpp"

#include <cstdlib>  // defines __GLIBC__ where it is the C library

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace asterism::apps {

namespace {

// Sets the size in bytes of the smallest blocks that are given back to the system when they are
// freed.
void give_back_from([[maybe_unused]] int bytes) {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, bytes);
  mallopt(M_TRIM_THRESHOLD, bytes);
#endif
}

}  // namespace

void give_back_large_blocks() {
  constexpr int large = 128 << 10;  // where the library begins by itself
  give_back_from(large);
}

void keep_freed_blocks() {
  constexpr int large = 32 << 20;  // the most that the library takes
  give_back_from(large);
}

void give_back_small_blocks() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace asterism::apps
