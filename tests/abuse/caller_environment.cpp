// SPDX-License-Identifier: MIT
#include "caller_environment.hpp"

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace asterism::abuse {

namespace {

#if defined(__SSE2__)
constexpr unsigned flushing_bits = 0x8040;
constexpr unsigned status_flags = 0x3F;
#endif

}  // namespace

void set_default_environment() { std::fesetenv(FE_DFL_ENV); }

void set_environment(int rounding, bool flushes) {
  set_default_environment();
  std::fesetround(rounding);
#if defined(__SSE2__)
  if (flushes) _mm_setcsr(_mm_getcsr() | flushing_bits);
#endif
}

caller_environment current_environment() {
  caller_environment now;
  now.rounding = std::fegetround();
#if defined(__SSE2__)
  now.control = _mm_getcsr() & ~status_flags;
  now.flushes = (now.control & flushing_bits) != 0;
  unsigned short x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  now.x87_control = x87;
#endif
  return now;
}

}  // namespace asterism::abuse
