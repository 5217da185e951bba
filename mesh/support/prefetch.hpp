// SPDX-License-Identifier: MIT
//
// Asks for memory that will be read soon. Where sites are given in any order, those around a site
// or a triangle are anywhere in memory, and reads that are not asked for early wait for each other.
#pragma once

#include <cstddef>

namespace asterism::internal {

// Number of triangles, or of sites with what is around them, that are asked for ahead: enough to
// do meanwhile, and few enough to be there still.
inline constexpr std::size_t triangles_ahead = 8, sites_ahead = 4;

// Asks for the line of memory at this address; changes nothing.
inline void prefetch(const void* address) {
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

}  // namespace asterism::internal
