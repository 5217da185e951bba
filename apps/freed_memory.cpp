// SPDX-License-Identifier: MIT
#include "asterism/apps/freed_memory.hpp"

#include <cstdlib>  // defines __GLIBC__ where it is the C library

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace asterism::apps {

void give_back_large_blocks() {
#ifdef __GLIBC__
  constexpr int large = 128 << 10;  // bytes; where the library begins by itself
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#endif
}

void give_back_small_blocks() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace asterism::apps
