// SPDX-License-Identifier: MIT
//
// Random numbers for inputs of benchmarks: the same on every machine. Consecutive small seeds give
// independent sequences.
#pragma once

#include "asterism/core/random.hpp"

namespace asterism::bench {

class random_source : public internal::splitmix64 {
 public:
  explicit random_source(std::uint64_t seed) : splitmix64(seed * 0xd1b54a32d192ed03U) {}
};

}  // namespace asterism::bench
