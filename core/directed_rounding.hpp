// SPDX-License-Identifier: MIT
//
// Defines whether arithmetic can be set to round upward. ASTERISM_DIRECTED_ROUNDING is 1 where
// floating_point_scope sets the rounding mode, and 0 where every operation rounds to nearest: there
// each bound of an interval that was rounded inward is moved outward by one unit in its last place
// (core/upward_arithmetic.hpp), which gives the same bounds, slower.
//
// It is 0 on WebAssembly, which has no rounding modes. Its headers may define FE_UPWARD all the
// same, and with -msse2 its compiler defines __SSE2__: neither says anything there. A build for any
// target may ask for 0 (CMake: ASTERISM_DIRECTED_ROUNDING=OFF); the whole program has to agree.
// A target that cannot have 1, and one about which nothing is known, is refused.
#pragma once

#if !defined(__wasm__) && !defined(__SSE2__)
#include <cfenv>
#endif

#if !defined(ASTERISM_DIRECTED_ROUNDING) && defined(__wasm__)
#define ASTERISM_DIRECTED_ROUNDING 0
#elif !defined(ASTERISM_DIRECTED_ROUNDING)
#define ASTERISM_DIRECTED_ROUNDING 1
#endif

#if ASTERISM_DIRECTED_ROUNDING && defined(__wasm__)
#error "asterism: WebAssembly cannot round upward: ASTERISM_DIRECTED_ROUNDING has to be 0 there"
#elif ASTERISM_DIRECTED_ROUNDING && !defined(__SSE2__) && !defined(FE_UPWARD)
#error "asterism: this target cannot round upward: define ASTERISM_DIRECTED_ROUNDING as 0"
#endif
