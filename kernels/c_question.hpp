// SPDX-License-Identifier: MIT
//
// Holds what the C functions share: the checks of a question's numbers, and the function that lets
// no exception pass to C.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/c_api.h"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {

// Tests the bits, because == takes subnormal numbers for zeros if the caller has switched them
// off.
inline bool is_finite(double x) {
  constexpr std::uint64_t exponent = 0x7FF0000000000000U;
  return (std::bit_cast<std::uint64_t>(x) & exponent) != exponent;
}
inline bool is_same(double x, double y) {
  const auto a = std::bit_cast<std::uint64_t>(x), b = std::bit_cast<std::uint64_t>(y);
  return a == b || ((a | b) << 1U) == 0;
}

inline asterism_status check_sites(const filtered_kernel& kernel, const batch_record& record) {
  const std::size_t sites = shape_of(record.question).sites;
  for (std::size_t i = 0; i < sites; ++i)
    if (!kernel.is_positive_definite(site_at(record, i).metric))
      return ASTERISM_NOT_POSITIVE_DEFINITE;
  for (std::size_t i = 0; i < sites; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_same(record.numbers[5 * i], record.numbers[5 * j]) &&
          is_same(record.numbers[5 * i + 1], record.numbers[5 * j + 1]))
        return ASTERISM_EQUAL_SITES;
  return ASTERISM_OK;
}

// True if the metric m11 m12 m22, of finite numbers, is positive definite for certain; in doubles,
// in any rounding mode and with subnormal numbers switched off. With u = 2^-53 the products are off
// by a factor 1 + 2u at most, upward or downward, and m12^2 by 2^-1020 where it is that small; so a
// computed product above both (1 + 8u) times the computed square and 2^-900 proves m11 m22 > m12^2.
inline bool is_surely_positive_definite(const double* m) {
  constexpr double more = 1 + 0x1p-50, least = 0x1p-900;
  const double product = m[0] * m[2], square = m[1] * m[1];
  return (m[0] > 0) & (product > square * more) & (product > least);
}

// True if two points, of finite numbers, certainly differ.
inline bool are_surely_apart(const double* p, const double* q) {
  return (p[0] != q[0]) | (p[1] != q[1]);
}

// Returns every fault that the numbers of a question can have.
inline asterism_status check_record(const filtered_kernel& kernel, const batch_record& record) {
  const std::size_t count = numbers_of(record.question);
  for (std::size_t k = 0; k < count; ++k)
    if (!is_finite(record.numbers[k])) return ASTERISM_NOT_FINITE;
  if (record.question == predicate::in_circle && !kernel.is_positive_definite(metric_at(record, 0)))
    return ASTERISM_NOT_POSITIVE_DEFINITE;
  return check_sites(kernel, record);
}

// Returns the status of body(), which may throw; exceptions must not reach a caller in C.
template <class Body>
asterism_status without_exceptions(const Body& body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return ASTERISM_OUT_OF_MEMORY;
  } catch (...) {
    return ASTERISM_INTERNAL_FAILURE;
  }
}

}  // namespace asterism::internal
