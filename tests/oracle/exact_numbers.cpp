// SPDX-License-Identifier: MIT
#include "exact_numbers.hpp"

#include <CGAL/Polynomial_traits_d.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace asterism::oracle {
namespace {

using polynomial_1 = algebraic_kernel_1::Polynomial_1;

polynomial_1 with_integer_coefficients(const univariate& p) {
  integer denominator = 1;
  for (const rational& c : p) {
    const integer d = CORE::denominator(c);
    denominator = denominator / CORE::gcd(denominator, d) * d;
  }
  std::vector<integer> coefficients;
  coefficients.reserve(p.size());
  for (const rational& c : p)
    coefficients.push_back(CORE::numerator(c) * (denominator / CORE::denominator(c)));
  return polynomial_1(coefficients.begin(), coefficients.end());
}

template <class Operation>
univariate combine(const univariate& a, const univariate& b, Operation operation) {
  univariate sum(std::max(a.size(), b.size()), rational(0));
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = operation(i < a.size() ? a[i] : rational(0), i < b.size() ? b[i] : rational(0));
  return sum;
}

}  // namespace

exact_site to_exact(const site& s) {
  return {to_exact(s.position),
          {rational(s.metric.m11), rational(s.metric.m12), rational(s.metric.m22)},
          rational(0)};
}

basic_point<rational> to_exact(const point& p) { return {rational(p.x), rational(p.y)}; }

univariate operator+(const univariate& a, const univariate& b) {
  return combine(a, b, [](const rational& s, const rational& t) { return s + t; });
}

univariate operator-(const univariate& a, const univariate& b) {
  return combine(a, b, [](const rational& s, const rational& t) { return s - t; });
}

univariate operator*(const univariate& a, const univariate& b) {
  if (a.empty() || b.empty()) return {};
  univariate product(a.size() + b.size() - 1, rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}

bool is_zero(const univariate& p) {
  return std::all_of(p.begin(), p.end(), [](const rational& c) { return c == rational(0); });
}

rational evaluate(const univariate& p, const rational& at) {
  rational value(0);
  for (std::size_t i = p.size(); i-- > 0;) value = value * at + p[i];
  return value;
}

std::vector<algebraic_number> distinct_real_roots(const univariate& p) {
  std::vector<algebraic_number> roots;
  algebraic_kernel_1().solve_1_object()(with_integer_coefficients(p), false,
                                        std::back_inserter(roots));
  return roots;
}

bool are_coprime(const univariate& p, const univariate& q) {
  return algebraic_kernel_1().is_coprime_1_object()(with_integer_coefficients(p),
                                                    with_integer_coefficients(q));
}

bool is_square_free(const univariate& p) {
  return algebraic_kernel_1().is_square_free_1_object()(with_integer_coefficients(p));
}

std::vector<rational> samples_between(const std::vector<algebraic_number>& ascending) {
  if (ascending.empty()) return {rational(0)};
  const algebraic_kernel_1 kernel;
  const auto enclosure = kernel.approximate_absolute_1_object();
  const auto between = kernel.bound_between_1_object();
  std::vector<rational> samples = {enclosure(ascending.front(), 1).first - rational(1)};
  for (std::size_t i = 1; i < ascending.size(); ++i)
    samples.push_back(between(ascending[i - 1], ascending[i]));
  samples.push_back(enclosure(ascending.back(), 1).second + rational(1));
  return samples;
}

}  // namespace asterism::oracle
