// SPDX-License-Identifier: MIT
//
// A small generator of numbers that are the same on every machine (SplitMix64; Steele, Lea, Flood
// 2014): the standard distributions are not.
#pragma once

#include <cstdint>

namespace asterism::property {

class random_source {
 public:
  explicit random_source(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  // Both ends included. The bias is below 2^-50 for the ranges used here.
  int integer(int low, int high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(next() % span);
  }

  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1p-53);
  }

  bool chance(int one_in) { return integer(1, one_in) == 1; }

 private:
  std::uint64_t state_;
};

}  // namespace asterism::property
