// SPDX-License-Identifier: MIT
#include "asterism/kernels/numeric_roots.hpp"

#include <cmath>

namespace asterism::internal::numeric {

namespace {

using coefficients = std::array<double, 5>;

double value_at(const coefficients& c, int degree, double x) {
  double value = c[static_cast<std::size_t>(degree)];
  for (int k = degree; k-- > 0;) value = value * x + c[static_cast<std::size_t>(k)];
  return value;
}

// Returns the root of c in [low, high], where its values have different signs, by Newton's method,
// kept inside the shrinking bracket by bisection.
double bracketed_root(const coefficients& c, const coefficients& slope, int degree, double low,
                      double high) {
  const bool rising = value_at(c, degree, high) > 0;
  double x = 0.5 * (low + high);
  constexpr int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    const double value = value_at(c, degree, x);
    if (value == 0) return x;
    ((value > 0) == rising ? high : low) = x;
    double next = x - value / value_at(slope, degree - 1, x);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= 0x1p-50 * std::abs(next) || next == low || next == high) return next;
    x = next;
  }
  return x;
}

// Appends the roots of c in [-1, 1] to `roots`, in increasing order.
void roots_in_unit_range(const coefficients& c, int degree, std::array<double, 8>& roots,
                         std::size_t& count) {
  while (degree > 0 && c[static_cast<std::size_t>(degree)] == 0) --degree;
  if (degree == 0) return;
  coefficients slope{};
  for (int k = 1; k <= degree; ++k)
    slope[static_cast<std::size_t>(k - 1)] = k * c[static_cast<std::size_t>(k)];
  std::array<double, 8> turning{};
  std::size_t turns = 0;
  roots_in_unit_range(slope, degree - 1, turning, turns);
  double low = -1;
  for (std::size_t k = 0; k <= turns; ++k) {
    const double high = k < turns ? turning[k] : 1;
    const double at_low = value_at(c, degree, low), at_high = value_at(c, degree, high);
    if (at_high == 0 && high > low)
      roots[count++] = high;
    else if ((at_low < 0) != (at_high < 0) && at_low != 0)
      roots[count++] = bracketed_root(c, slope, degree, low, high);
    low = high;
  }
}

}  // namespace

root_list real_roots(const coefficients& c) {
  std::array<double, 8> inner{}, reciprocal{};
  std::size_t inner_count = 0, reciprocal_count = 0;
  roots_in_unit_range(c, 4, inner, inner_count);
  // Takes the roots beyond [-1, 1] as reciprocals of those of the reversed polynomial.
  roots_in_unit_range({c[4], c[3], c[2], c[1], c[0]}, 4, reciprocal, reciprocal_count);
  root_list result;
  const auto append = [&](double x) {
    if (result.count == result.value.size()) return;
    std::size_t k = result.count++;
    for (; k > 0 && result.value[k - 1] > x; --k) result.value[k] = result.value[k - 1];
    result.value[k] = x;
  };
  for (std::size_t k = 0; k < inner_count; ++k) append(inner[k]);
  for (std::size_t k = 0; k < reciprocal_count; ++k)
    if (reciprocal[k] != 0 && std::abs(reciprocal[k]) < 1) append(1 / reciprocal[k]);
  return result;
}

}  // namespace asterism::internal::numeric
