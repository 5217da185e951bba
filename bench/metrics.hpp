// SPDX-License-Identifier: MIT
//
// Metrics of the benchmarks' sites, and places at a given length and angle in a metric.
#pragma once

#include <cmath>
#include <numbers>

#include "asterism/core/plane_algebra.hpp"
#include "random_source.hpp"

namespace asterism::bench {
using namespace internal;

inline constexpr metric_tensor round_metric{1, 0, 1};

// I + 12 p p^T: stretched along circles, with aspects up to 5 on the square.
inline metric_tensor swirl(const point& p) {
  return {1 + 12 * p.x * p.x, 12 * p.x * p.y, 1 + 12 * p.y * p.y};
}

// Returns the tensor with eigenvalues 1 and `condition`; the first's direction is `angle`.
inline metric_tensor stretched(double condition, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c + condition * (s * s), (1 - condition) * (c * s), s * s + condition * (c * c)};
}

// Returns the displacement of length `length` in m, at `angle` in the frame in which m is round.
inline displacement<double> at_length(const metric_tensor& m, double length, double angle) {
  const double a = std::sqrt(m.m11), b = m.m12 / a, c = std::sqrt(m.m22 - b * b);
  const double y = length * std::sin(angle) / c;
  return {(length * std::cos(angle) - b * y) / a, y};
}

inline point moved(const point& p, const displacement<double>& u, double factor = 1) {
  return {p.x + factor * u.x, p.y + factor * u.y};
}

inline point random_point(random_source& random) {
  const double x = random.real(-1, 1);
  return {x, random.real(-1, 1)};
}

inline double random_angle(random_source& random) {
  return random.real(-std::numbers::pi, std::numbers::pi);
}

// Draws k / 2^20 in [-1, 1]: sums and products of two are exact.
inline double few_bits(random_source& random) {
  return std::ldexp(static_cast<double>(random.integer(-1 << 20, 1 << 20)), -20);
}

// Moves the point left or right by some units in the last place.
inline double nudged(double x, random_source& random) {
  const int steps = random.integer(-2, 2);
  for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps * 1e300);
  return x;
}
inline point nudged(const point& p, random_source& random) {
  const double x = nudged(p.x, random);
  return {x, nudged(p.y, random)};
}

inline site scaled(const site& s, int exponent) {
  return {{std::ldexp(s.position.x, exponent), std::ldexp(s.position.y, exponent)}, s.metric};
}

}  // namespace asterism::bench
