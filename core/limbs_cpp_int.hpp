// SPDX-License-Identifier: MIT
//
// Provides the functions of core/limbs_gmp.hpp without GMP, for the build with
// ASTERISM_EXACT=cpp_int: loops for operations of one pass, Boost's cpp_int for division, divisors
// and roots. Slower than GMP, but its licence puts no conditions on programs linked to it.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace asterism::internal::limbs {

using limb = std::uint64_t;
__extension__ using wide_limb = unsigned __int128;
using boost::multiprecision::cpp_int;

inline limb multiply(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  std::fill(to, to + n + m, limb{0});
  for (std::size_t j = 0; j < m; ++j) {
    limb carry = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const wide_limb sum = static_cast<wide_limb>(a[i]) * b[j] + to[i + j] + carry;
      to[i + j] = static_cast<limb>(sum);
      carry = static_cast<limb>(sum >> 64);
    }
    to[n + j] = carry;
  }
  return to[n + m - 1];
}

inline limb add(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  limb carry = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const wide_limb sum = static_cast<wide_limb>(a[k]) + (k < m ? b[k] : 0) + carry;
    to[k] = static_cast<limb>(sum);
    carry = static_cast<limb>(sum >> 64);
  }
  return carry;
}

inline void subtract(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  limb borrow = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const limb from = a[k], take = k < m ? b[k] : 0;
    to[k] = from - take - borrow;
    borrow = from < take || (from == take && borrow != 0) ? 1 : 0;
  }
}

inline bool is_less(const limb* a, const limb* b, std::size_t n) {
  while (n > 0 && a[n - 1] == b[n - 1]) --n;
  return n > 0 && a[n - 1] < b[n - 1];
}

// Works from the top down, because `to` may lie above a.
inline limb shift_left(limb* to, const limb* a, std::size_t n, unsigned bits) {
  const limb out = a[n - 1] >> (64 - bits);
  for (std::size_t k = n; k-- > 0;) to[k] = (a[k] << bits) | (k > 0 ? a[k - 1] >> (64 - bits) : 0);
  return out;
}

inline void shift_right(limb* to, const limb* a, std::size_t n, unsigned bits) {
  for (std::size_t k = 0; k < n; ++k)
    to[k] = (a[k] >> bits) | (k + 1 < n ? a[k + 1] << (64 - bits) : 0);
}

inline cpp_int to_cpp_int(const limb* a, std::size_t n) {
  cpp_int value;
  import_bits(value, a, a + n, 64, false);
  return value;
}

// Writes the value to `room` limbs, with zeros above it; returns its number of limbs, without these
// zeros.
inline std::size_t from_cpp_int(const cpp_int& value, limb* to, std::size_t room) {
  limb* const end = value == 0 ? to : export_bits(value, to, 64, false);
  std::fill(end, to + room, limb{0});
  return static_cast<std::size_t>(end - to);
}

inline void divide(limb* quotient, limb* rest, const limb* a, std::size_t n, const limb* b,
                   std::size_t m) {
  cpp_int whole, left;
  divide_qr(to_cpp_int(a, n), to_cpp_int(b, m), whole, left);
  from_cpp_int(whole, quotient, n - m + 1);
  from_cpp_int(left, rest, m);
}

inline std::size_t greatest_common_divisor(limb* to, const limb* a, std::size_t n, const limb* b,
                                           std::size_t m) {
  return from_cpp_int(gcd(to_cpp_int(a, n), to_cpp_int(b, m)), to, m);
}

inline bool square_root(limb* root, limb* rest, const limb* a, std::size_t n) {
  cpp_int left;
  const cpp_int found = sqrt(to_cpp_int(a, n), left);
  from_cpp_int(found, root, (n + 1) / 2);
  from_cpp_int(left, rest, n);
  return left == 0;
}

}  // namespace asterism::internal::limbs
