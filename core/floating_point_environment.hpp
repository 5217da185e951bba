// SPDX-License-Identifier: MIT
//
// Opens a scope with a known floating-point environment: all exceptions masked, no flush-to-zero,
// no denormals-are-zero, the rounding mode asked for. The caller's environment, status flags
// included, is restored at the end of the scope. Costs a few nanoseconds.
//
// The compiler does not order arithmetic against a change of the environment: do the arithmetic in
// a function that is not inlined into the one that holds the scope.
//
// Without directed rounding (core/directed_rounding.hpp) both modes are the one to nearest, and
// rounded_interval rounds outward by itself. WebAssembly has one environment, and a scope does
// nothing there.
#pragma once

// Refuses -ffast-math in all its parts; Clang defines a macro only when all are on.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "asterism: exact predicates cannot be compiled with -ffast-math"
#endif
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "asterism: exact predicates need doubles that are rounded to doubles: -mfpmath=sse"
#endif

#include "asterism/core/directed_rounding.hpp"

#if defined(__SSE2__) && !defined(__wasm__)
#include <xmmintrin.h>
#elif !defined(__wasm__)
#include <cfenv>
#endif

namespace asterism::internal {

enum class rounding { nearest, upward };

// True if a scope of this mode has arithmetic round upward.
constexpr bool is_upward(rounding mode) {
  return ASTERISM_DIRECTED_ROUNDING && mode == rounding::upward;
}

class floating_point_scope {
 public:
  floating_point_scope(const floating_point_scope&) = delete;
  floating_point_scope& operator=(const floating_point_scope&) = delete;

#if defined(__wasm__)
  explicit floating_point_scope(rounding) {}
  ~floating_point_scope() {}
#elif defined(__SSE2__)
  explicit floating_point_scope(rounding mode) : saved_(_mm_getcsr()) {
    constexpr unsigned all_masked = 0x1F80, round_up = 0x4000;
    _mm_setcsr(is_upward(mode) ? all_masked | round_up : all_masked);
  }
  ~floating_point_scope() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
#else
  explicit floating_point_scope(rounding mode) {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
#if ASTERISM_DIRECTED_ROUNDING
    std::fesetround(is_upward(mode) ? FE_UPWARD : FE_TONEAREST);
#endif
  }
  ~floating_point_scope() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_;
#endif
};

}  // namespace asterism::internal
