// SPDX-License-Identifier: MIT
//
// Provides the arithmetic of core/integer.cpp on arrays of limbs, the least significant first, by
// GMP's mpn functions. core/limbs_cpp_int.hpp has the same functions without GMP.
//
// n and m are the lengths of a and b, at least 1 unless said otherwise. `to` may be a; lengths of
// results are said with each function.
#pragma once

#include <gmp.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace asterism::internal::limbs {

using limb = std::uint64_t;
static_assert(GMP_NUMB_BITS == 64 && std::is_same_v<mp_limb_t, limb>);

inline mp_size_t signed_size(std::size_t limbs) { return static_cast<mp_size_t>(limbs); }

// Writes n + m limbs, of which the top one is returned. Requires n >= m; `to` is neither a nor b.
inline limb multiply(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  if (m == 1) return to[n] = mpn_mul_1(to, a, signed_size(n), b[0]);
  return mpn_mul(to, a, signed_size(n), b, signed_size(m));
}
// Writes n limbs; the carry is returned. Requires n >= m; `to` may be b as well.
inline limb add(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  return mpn_add(to, a, signed_size(n), b, signed_size(m));
}
// Writes n limbs. Requires a >= b and n >= m; `to` may be b as well.
inline void subtract(limb* to, const limb* a, std::size_t n, const limb* b, std::size_t m) {
  mpn_sub(to, a, signed_size(n), b, signed_size(m));
}
inline bool is_less(const limb* a, const limb* b, std::size_t n) {
  return mpn_cmp(a, b, signed_size(n)) < 0;
}
// Writes n limbs; returns the bits shifted out at the top. 0 < bits < 64; `to` may lie above a.
inline limb shift_left(limb* to, const limb* a, std::size_t n, unsigned bits) {
  return mpn_lshift(to, a, signed_size(n), bits);
}
// Writes n limbs. 0 < bits < 64; `to` may lie below a.
inline void shift_right(limb* to, const limb* a, std::size_t n, unsigned bits) {
  mpn_rshift(to, a, signed_size(n), bits);
}
// Writes n - m + 1 limbs of the quotient, m of the rest. Requires n >= m and b[m - 1] != 0.
inline void divide(limb* quotient, limb* rest, const limb* a, std::size_t n, const limb* b,
                   std::size_t m) {
  mpn_tdiv_qr(quotient, rest, 0, a, signed_size(n), b, signed_size(m));
}
// Returns the number of limbs, at most m. Requires odd numbers, a of at least as many bits as b;
// both are overwritten.
inline std::size_t greatest_common_divisor(limb* to, limb* a, std::size_t n, limb* b,
                                           std::size_t m) {
  return static_cast<std::size_t>(mpn_gcd(to, a, signed_size(n), b, signed_size(m)));
}
// Writes (n + 1) / 2 limbs of the root, and the rest, for which there must be room of n. True if
// there is no rest. Requires a[n - 1] != 0.
inline bool square_root(limb* root, limb* rest, const limb* a, std::size_t n) {
  return mpn_sqrtrem(root, rest, a, signed_size(n)) == 0;
}

}  // namespace asterism::internal::limbs
