// SPDX-License-Identifier: MIT
//
// Holds two doubles in one register, by which the semi-static tier computes values of two sites at
// once. Every operation is that of two doubles one by one, in any floating-point environment.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace asterism::internal {

// + - * work lane by lane; x[0] and x[1] are the lanes.
using two_doubles = double __attribute__((vector_size(16)));

inline two_doubles pair(double a, double b) { return two_doubles{a, b}; }
inline two_doubles both(double x) { return two_doubles{x, x}; }
inline two_doubles absolute(two_doubles x) {
  using two_integers = std::int64_t __attribute__((vector_size(16)));
  constexpr std::int64_t all_but_sign = INT64_MAX;
  return reinterpret_cast<two_doubles>(reinterpret_cast<two_integers>(x) &
                                       two_integers{all_but_sign, all_but_sign});
}
inline two_doubles exchanged(two_doubles x) { return two_doubles{x[1], x[0]}; }
inline double sum(two_doubles x) { return x[0] + x[1]; }
inline double difference(two_doubles x) { return x[0] - x[1]; }

// True if a < b in both lanes; false of a NaN.
inline bool both_less(two_doubles a, two_doubles b) {
#if defined(__SSE2__)
  return _mm_movemask_pd(_mm_cmplt_pd(a, b)) == 3;
#else
  return (a[0] < b[0]) & (a[1] < b[1]);
#endif
}
// Returns the greater number in each lane; that of b if either is a NaN.
inline two_doubles greatest(two_doubles a, two_doubles b) {
#if defined(__SSE2__)
  return _mm_max_pd(a, b);
#else
  return two_doubles{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
#endif
}
// True if some lane of x is less than that of `least`, or greater than that of `most`.
inline bool any_outside(two_doubles x, two_doubles least, two_doubles most) {
#if defined(__SSE2__)
  return _mm_movemask_pd(_mm_or_pd(_mm_cmplt_pd(x, least), _mm_cmplt_pd(most, x))) != 0;
#else
  return (x[0] < least[0]) | (x[0] > most[0]) | (x[1] < least[1]) | (x[1] > most[1]);
#endif
}
// True if some lane of a is less than that of b.
inline bool any_less(two_doubles a, two_doubles b) {
#if defined(__SSE2__)
  return _mm_movemask_pd(_mm_cmplt_pd(a, b)) != 0;
#else
  return (a[0] < b[0]) | (a[1] < b[1]);
#endif
}
// Returns a number whose bit k is lane k's sign bit.
inline unsigned sign_bits(two_doubles x) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(x));
#else
  return static_cast<unsigned>(std::signbit(x[0])) | static_cast<unsigned>(std::signbit(x[1])) << 1;
#endif
}

// A pair of displacements, points or metrics, one component of both in each vector.
struct two_displacements {
  two_doubles x, y;
};
inline two_displacements operator-(const two_displacements& a, const two_displacements& b) {
  return {a.x - b.x, a.y - b.y};
}

}  // namespace asterism::internal
