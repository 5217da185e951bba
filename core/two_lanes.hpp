// SPDX-License-Identifier: MIT
//
// Works on a pair of doubles at once: an SSE2 register where there is one, two doubles elsewhere or
// with ASTERISM_PORTABLE_LANES, by which a test compares the two. Sums, products, quotients and
// roots are rounded by the rounding mode in force, or upward by core/upward_arithmetic.hpp where
// there is no directed rounding (core/directed_rounding.hpp).
//
// A compiler may fold or move arithmetic as if the rounding mode were to nearest, for instance turn
// -(a * b) into (-a) * b. `opaque` hides a value from that. `opaque_here` also stays on its side of
// a change of the rounding mode, as the compiler does not reorder volatile accesses; arithmetic on
// a value that went through it and whose result goes through it is thus done in the mode meant.
#pragma once

#include <cmath>
#include <limits>

#include "asterism/core/directed_rounding.hpp"

#if !ASTERISM_DIRECTED_ROUNDING
#include "asterism/core/upward_arithmetic.hpp"
#elif defined(__SSE2__) && !defined(ASTERISM_PORTABLE_LANES)
#define ASTERISM_LANES_IN_A_REGISTER
#include <emmintrin.h>
#endif

namespace asterism::internal {

#if defined(ASTERISM_LANES_IN_A_REGISTER)

inline double opaque_here(double x) {
  asm volatile("" : "+x"(x));
  return x;
}

class two_lanes {
 public:
  two_lanes(double first, double second) : lanes_(_mm_setr_pd(first, second)) {}

  double first() const { return _mm_cvtsd_f64(lanes_); }
  double second() const { return _mm_cvtsd_f64(swapped().lanes_); }

  two_lanes swapped() const { return two_lanes(_mm_shuffle_pd(lanes_, lanes_, 1)); }
  two_lanes negated() const { return two_lanes(_mm_xor_pd(lanes_, _mm_set1_pd(-0.0))); }
  two_lanes first_negated() const { return two_lanes(_mm_xor_pd(lanes_, _mm_set_sd(-0.0))); }

  friend two_lanes product(const two_lanes& a, const two_lanes& b) {
    return two_lanes(_mm_mul_pd(a.lanes_, b.lanes_));
  }
  // Return the second of two numbers if one is NaN or both are zeros.
  friend two_lanes greatest(const two_lanes& a, const two_lanes& b) {
    return two_lanes(_mm_max_pd(a.lanes_, b.lanes_));
  }
  friend two_lanes smallest(const two_lanes& a, const two_lanes& b) {
    return two_lanes(_mm_min_pd(a.lanes_, b.lanes_));
  }
  // Returns the first lane of a and the second of b.
  friend two_lanes first_then_second(const two_lanes& a, const two_lanes& b) {
    return two_lanes(_mm_move_sd(b.lanes_, a.lanes_));
  }

  friend two_lanes opaque(two_lanes a) {
    asm("" : "+x"(a.lanes_));
    return a;
  }
  friend two_lanes opaque_here(two_lanes a) {
    asm volatile("" : "+x"(a.lanes_));
    return a;
  }
  friend two_lanes rounded_sum(const two_lanes& a, const two_lanes& b) {
    return opaque_here(two_lanes(_mm_add_pd(opaque_here(a).lanes_, opaque(b).lanes_)));
  }

 private:
  explicit two_lanes(__m128d lanes) : lanes_(lanes) {}

  __m128d lanes_;
};

#else

inline double opaque_here(double x) {
#if !ASTERISM_DIRECTED_ROUNDING
  return x;  // no mode is changed, and folding to nearest is right
#elif defined(__GNUC__)
  asm volatile("" : "+m"(x));
  return x;
#else
  volatile double hidden = x;
  return hidden;
#endif
}

#if ASTERISM_DIRECTED_ROUNDING
inline double lane_product(double a, double b) { return a * b; }
inline double lane_sum(double a, double b) { return a + b; }
#else
inline double lane_product(double a, double b) { return upward::product(a, b); }
inline double lane_sum(double a, double b) { return upward::sum(a, b); }
#endif

class two_lanes {
 public:
  two_lanes(double first, double second) : first_(first), second_(second) {}

  double first() const { return first_; }
  double second() const { return second_; }

  two_lanes swapped() const { return {second_, first_}; }
  two_lanes negated() const { return {-first_, -second_}; }
  two_lanes first_negated() const { return {-first_, second_}; }

  friend two_lanes product(const two_lanes& a, const two_lanes& b) {
    return {lane_product(a.first_, b.first_), lane_product(a.second_, b.second_)};
  }
  // Return the second of two numbers if one is NaN or both are zeros.
  friend two_lanes greatest(const two_lanes& a, const two_lanes& b) {
    return {a.first_ > b.first_ ? a.first_ : b.first_,
            a.second_ > b.second_ ? a.second_ : b.second_};
  }
  friend two_lanes smallest(const two_lanes& a, const two_lanes& b) {
    return {a.first_ < b.first_ ? a.first_ : b.first_,
            a.second_ < b.second_ ? a.second_ : b.second_};
  }
  // Returns the first lane of a and the second of b.
  friend two_lanes first_then_second(const two_lanes& a, const two_lanes& b) {
    return {a.first_, b.second_};
  }

  friend two_lanes opaque_here(const two_lanes& a) {
    return {asterism::internal::opaque_here(a.first_), asterism::internal::opaque_here(a.second_)};
  }
  friend two_lanes opaque(const two_lanes& a) { return opaque_here(a); }
  friend two_lanes rounded_sum(const two_lanes& a, const two_lanes& b) {
    const two_lanes x = opaque_here(a), y = opaque_here(b);
    return opaque_here(two_lanes(lane_sum(x.first_, y.first_), lane_sum(x.second_, y.second_)));
  }

 private:
  double first_, second_;
};

#endif

// Work on the two numbers one at a time.
#if ASTERISM_DIRECTED_ROUNDING
inline double rounded_sum(double a, double b) {
  return opaque_here(opaque_here(a) + opaque_here(b));
}
inline double rounded_product(double a, double b) {
  return opaque_here(opaque_here(a) * opaque_here(b));
}
inline double rounded_quotient(double a, double b) {
  return opaque_here(opaque_here(a) / opaque_here(b));
}
inline double rounded_root(double x) {
#if defined(ASTERISM_LANES_IN_A_REGISTER)
  const __m128d wide = _mm_set_sd(opaque_here(x));
  return opaque_here(_mm_cvtsd_f64(_mm_sqrt_sd(wide, wide)));
#else
  return opaque_here(std::sqrt(opaque_here(x)));
#endif
}
#else
inline double rounded_sum(double a, double b) { return upward::sum(a, b); }
inline double rounded_product(double a, double b) { return upward::product(a, b); }
inline double rounded_quotient(double a, double b) { return upward::quotient(a, b); }
inline double rounded_root(double x) { return upward::root(x); }
#endif

// Returns a, infinite where it is NaN.
inline two_lanes not_nan(const two_lanes& a) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return smallest(a, two_lanes(infinity, infinity));
}

}  // namespace asterism::internal

#undef ASTERISM_LANES_IN_A_REGISTER
