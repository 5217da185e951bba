// SPDX-License-Identifier: MIT
//
// Defines polynomials in one variable whose formal degree is part of the type. They have the
// operations that formulas need: no division, and no allocation beyond that of the number type.
// Leading coefficients may vanish. The coefficients of a default polynomial are those of a default
// number: unspecified for intervals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace asterism::internal {

template <class Number, std::size_t Degree>
struct polynomial {
  static constexpr std::size_t degree = Degree;
  std::array<Number, Degree + 1> coefficient;  // of x^0, x^1, ...

  Number operator()(const Number& x) const {
    Number value = coefficient[Degree];
    for (std::size_t k = Degree; k-- > 0;) value = value * x + coefficient[k];
    return value;
  }
};

template <class Number, std::size_t N, std::size_t M>
polynomial<Number, N + M> operator*(const polynomial<Number, N>& p,
                                    const polynomial<Number, M>& q) {
  polynomial<Number, N + M> product;
  product.coefficient.fill(Number(0));
  for (std::size_t i = 0; i <= N; ++i)
    for (std::size_t j = 0; j <= M; ++j)
      product.coefficient[i + j] = product.coefficient[i + j] + p.coefficient[i] * q.coefficient[j];
  return product;
}

template <class Number, std::size_t N>
polynomial<Number, N> operator*(const Number& factor, const polynomial<Number, N>& p) {
  polynomial<Number, N> product;
  for (std::size_t i = 0; i <= N; ++i) product.coefficient[i] = factor * p.coefficient[i];
  return product;
}

template <class Number, std::size_t N, std::size_t M>
auto operator+(const polynomial<Number, N>& p, const polynomial<Number, M>& q) {
  polynomial<Number, std::max(N, M)> sum;
  sum.coefficient.fill(Number(0));
  for (std::size_t i = 0; i <= N; ++i) sum.coefficient[i] = p.coefficient[i];
  for (std::size_t i = 0; i <= M; ++i) sum.coefficient[i] = sum.coefficient[i] + q.coefficient[i];
  return sum;
}

template <class Number, std::size_t N, std::size_t M>
auto operator-(const polynomial<Number, N>& p, const polynomial<Number, M>& q) {
  polynomial<Number, std::max(N, M)> difference;
  difference.coefficient.fill(Number(0));
  for (std::size_t i = 0; i <= N; ++i) difference.coefficient[i] = p.coefficient[i];
  for (std::size_t i = 0; i <= M; ++i)
    difference.coefficient[i] = difference.coefficient[i] - q.coefficient[i];
  return difference;
}

}  // namespace asterism::internal
