// SPDX-License-Identifier: MIT
//
// Generates pseudorandom numbers that are the same on every machine, which the standard
// distributions are not: splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
// generators", 2014). For sampling and for tests; nothing that must be right depends on them.
#pragma once

#include <cstdint>

namespace asterism::internal {

// Mixes the bits of z so that each bit of the result depends on all of them. A bijection.
constexpr std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

// Returns the multiple of 2^-53 in [0, 1) that the upper 53 bits make.
constexpr double unit_fraction(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

// Returns a number in [0, 1) that depends on all bits of a and b, and on nothing else: a number for
// a place or an attempt that does not depend on numbers drawn before.
constexpr double fraction_of(std::uint64_t a, std::uint64_t b) {
  return unit_fraction(mixed_bits(a * 0x9e3779b97f4a7c15U + b * 0xd1342543de82ef95U + 1));
}

class splitmix64 {
 public:
  constexpr explicit splitmix64(std::uint64_t seed) : state_(seed) {}

  // The state, to be kept: a generator made with it as seed continues the sequence from here.
  constexpr std::uint64_t state() const { return state_; }

  constexpr std::uint64_t bits() { return mixed_bits(state_ += 0x9e3779b97f4a7c15U); }
  // Returns a multiple of 2^-53, uniform in [0, 1).
  constexpr double real() { return unit_fraction(bits()); }
  constexpr double real(double low, double high) { return low + (high - low) * real(); }
  // Returns an integer, uniform in [0, n) up to a bias below n / 2^64.
  constexpr std::uint64_t below(std::uint64_t n) { return bits() % n; }
  // Returns an integer, uniform from low to high, both included.
  constexpr int integer(int low, int high) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{high} - low) + 1;
    return low + static_cast<int>(below(count));
  }
  // Returns true with the probability 1 / one_in.
  constexpr bool chance(int one_in) { return integer(1, one_in) == 1; }

 private:
  std::uint64_t state_;
};

}  // namespace asterism::internal
