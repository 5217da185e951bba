// SPDX-License-Identifier: MIT
//
// Says how many threads --threads takes: one in a program that was built without oneTBB.
#pragma once

#include <cstdint>

namespace asterism::apps {

#ifdef ASTERISM_ONE_THREAD
inline constexpr std::uint64_t most_threads = 1;
#else
inline constexpr std::uint64_t most_threads = 1024;
#endif

}  // namespace asterism::apps
