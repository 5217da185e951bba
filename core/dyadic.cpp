// SPDX-License-Identifier: MIT
#include "asterism/core/dyadic.hpp"

#include <bit>
#include <cassert>
#include <cstdint>

namespace asterism {

namespace {

constexpr int fraction_bits = 52;
constexpr int exponent_bias = 1075;  // of the fraction read as an integer

}  // namespace

dyadic::dyadic(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  auto fraction = static_cast<std::int64_t>(bits & ((std::uint64_t{1} << fraction_bits) - 1));
  const int biased = static_cast<int>((bits >> fraction_bits) & 0x7FF);
  assert(biased != 0x7FF);
  if (biased != 0) fraction |= std::int64_t{1} << fraction_bits;
  if (fraction == 0) return;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(fraction));
  fraction >>= zeros;
  mantissa_ = (bits >> 63) != 0 ? -fraction : fraction;
  exponent_ = (biased == 0 ? 1 : biased) - exponent_bias + zeros;
}

dyadic dyadic::sum(const dyadic& a, const dyadic& b, bool subtract) {
  if (b.is_zero()) return a;
  if (a.is_zero()) return subtract ? -b : b;
  integer left = a.mantissa_, right = b.mantissa_;
  long exponent = a.exponent_;
  if (a.exponent_ > b.exponent_) {
    left <<= static_cast<unsigned long>(a.exponent_ - b.exponent_);
    exponent = b.exponent_;
  } else if (b.exponent_ > a.exponent_) {
    right <<= static_cast<unsigned long>(b.exponent_ - a.exponent_);
  }
  if (subtract)
    left -= right;
  else
    left += right;
  return {std::move(left), exponent};
}

long dyadic::magnitude() const {
  return static_cast<long>(mpz_sizeinbase(mantissa_.backend().data(), 2)) + exponent_;
}

void dyadic::shorten() {
  if (is_zero()) {
    exponent_ = 0;
    return;
  }
  const unsigned long zeros = mpz_scan1(mantissa_.backend().data(), 0);
  mantissa_ >>= zeros;
  exponent_ += static_cast<long>(zeros);
}

}  // namespace asterism
