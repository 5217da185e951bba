// SPDX-License-Identifier: MIT
//
// Prefetches memory that will be read soon. Where sites are given in any order, those around a site
// or a triangle are anywhere in memory, and reads without a prefetch wait for each other.
#pragma once

#include <cstddef>

namespace asterism::internal {

// Number of triangles, or of sites with their surroundings, that are prefetched ahead: enough to
// hide the time of a read, and few enough to be in the cache still.
inline constexpr std::size_t triangles_ahead = 8, sites_ahead = 4;

// Prefetches the line of memory at this address; changes nothing.
inline void prefetch(const void* address) {
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

}  // namespace asterism::internal
