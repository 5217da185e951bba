// SPDX-License-Identifier: MIT
//
// Adds, multiplies and solves polynomials of small degree in doubles, for the constructions.
// Coefficients go from the constant up.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace asterism::internal {

template <std::size_t Degree>
using coefficients = std::array<double, Degree + 1>;

// Coefficients of a polynomial of this degree, which are one more than the degree.
template <std::size_t P, std::size_t Q>
std::array<double, P + Q - 1> multiply(const std::array<double, P>& p,
                                       const std::array<double, Q>& q) {
  std::array<double, P + Q - 1> product{};
  for (std::size_t i = 0; i < P; ++i)
    for (std::size_t j = 0; j < Q; ++j) product[i + j] += p[i] * q[j];
  return product;
}

// Returns a p + b q.
template <std::size_t N>
std::array<double, N> combine(double a, const std::array<double, N>& p, double b,
                              const std::array<double, N>& q) {
  std::array<double, N> sum{};
  for (std::size_t i = 0; i < N; ++i) sum[i] = a * p[i] + b * q[i];
  return sum;
}

double evaluate(const std::vector<double>& p, double at);

// Returns approximations of the real roots, and of places where p comes near zero without a sign
// change (a double root split by rounding): for p of degree up to four, at most 4 + 3 values,
// increasing. Leading coefficients below 1e-14 of the largest count as zero.
std::vector<double> real_roots(std::vector<double> p);

// Returns the real roots of a s^2 + b s + c, increasing; a double root once; none when all are
// zero.
std::vector<double> quadratic_roots(double a, double b, double c);

}  // namespace asterism::internal
