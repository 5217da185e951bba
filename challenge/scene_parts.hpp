// SPDX-License-Identifier: MIT
//
// Makes small numbers, points and tensors, from which scenes are put together.
#pragma once

#include <cmath>
#include <limits>

#include "asterism/challenge/scene.hpp"

namespace asterism::challenge {

// Returns a random whole number whose absolute value is at most `size`.
inline double small_integer(random_source& random, int size) { return random.integer(-size, size); }

inline point integer_point(random_source& random, int size) {
  const double x = small_integer(random, size);
  return {x, small_integer(random, size)};
}

inline metric_tensor integer_metric(random_source& random, int size) {
  const double m11 = random.integer(1, size), m12 = small_integer(random, size / 2);
  return {m11, m12, double(random.integer(1, size))};
}

// Returns L L^T with a random triangular L.
inline metric_tensor real_metric(random_source& random) {
  const double a = random.real(0.3, 3), b = random.real(-2, 2), c = random.real(0.3, 3);
  return {a * a, a * b, b * b + c * c};
}

// Returns the next double, upwards or downwards.
inline double neighbour(double x, random_source& random) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(x, random.chance(2) ? infinity : -infinity);
}

// Makes four sites of one kind, a point like one of them, and a tensor.
template <class Make>
scene each(random_source& random, Make make) {
  scene s;
  for (site& of : s.sites) of = make();
  s.at = make().position;
  s.tensor = random.chance(2) ? s.sites[0].metric : metric_tensor{1, random.real(0.9, 1.1), 1};
  return s;
}

}  // namespace asterism::challenge
