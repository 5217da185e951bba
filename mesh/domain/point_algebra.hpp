// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/core/site.hpp"

// Points as vectors of the plane, in plain doubles.
namespace asterism::internal {

inline point minus(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }
inline double dot(const point& a, const point& b) { return a.x * b.x + a.y * b.y; }
inline double distance_between(const point& a, const point& b) {
  return elementary::hypot(a.x - b.x, a.y - b.y);
}
inline bool is_finite(const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace asterism::internal
