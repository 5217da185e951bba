// SPDX-License-Identifier: MIT
//
// Defines pairs of doubles that stand for their sum, and exact sums and products as pairs.
#pragma once

#include <cstddef>
#include <span>

#include "asterism/core/floating_point_environment.hpp"

namespace asterism::internal::elementary {

// A sum head + tail, the tail at most about a unit in the last place of the head.
struct double_pair {
  double head = 0, tail = 0;
};

inline double_pair exact_sum(double a, double b) {
  const double s = a + b, b_part = s - a, a_part = s - b_part;
  return {s, (a - a_part) + (b - b_part)};
}

// Requires |a| >= |b| or a == 0.
inline double_pair exact_sum_of_ordered(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

// Requires |a|, |b| below 2^990, and the product away from underflow.
inline double_pair exact_product(double a, double b) {
  constexpr double splitter = 0x1p27 + 1;
  const double p = a * b;
  const double a_big = a * splitter, a_high = a_big - (a_big - a), a_low = a - a_high;
  const double b_big = b * splitter, b_high = b_big - (b_big - b), b_low = b - b_high;
  return {p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline double_pair product(const double_pair& a, const double_pair& b) {
  const double_pair p = exact_product(a.head, b.head);
  return exact_sum_of_ordered(p.head, p.tail + (a.head * b.tail + a.tail * b.head));
}

inline double_pair quotient(const double_pair& a, const double_pair& b) {
  const double q = a.head / b.head;
  const double_pair back = exact_product(q, b.head);
  return {q, (((a.head - back.head) - back.tail) + a.tail - q * b.tail) / b.head};
}

// Returns coefficients[0] + x coefficients[1] + ...
inline double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

}  // namespace asterism::internal::elementary
