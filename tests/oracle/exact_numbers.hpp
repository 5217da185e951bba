// SPDX-License-Identifier: MIT
//
// The oracle's numbers: rationals of any size, and sites and polynomials over them. They are plain
// and slow: no scaling, no filters, nothing shared with the kernels under test.
#pragma once

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/CORE_BigInt.h>
#include <CGAL/CORE_BigRat.h>

#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::oracle {

using integer = CORE::BigInt;
using rational = CORE::BigRat;
using algebraic_kernel_1 = CGAL::Algebraic_kernel_d_1<integer>;
using algebraic_number = algebraic_kernel_1::Algebraic_real_1;

inline int sign_of(const rational& value) { return CORE::sign(value); }

// A site with a constant added to its squared distance: f(q) = (q-p)^T M (q-p) + offset. The offset
// is zero except in the symbolic perturbation of ties.
struct exact_site {
  basic_point<rational> position;
  basic_metric_tensor<rational> metric;
  rational offset{0};
};

exact_site to_exact(const site& s);
basic_point<rational> to_exact(const point& p);

// Coefficients from the constant term upwards. Leading coefficients may be zero.
using univariate = std::vector<rational>;

univariate operator+(const univariate& a, const univariate& b);
univariate operator-(const univariate& a, const univariate& b);
univariate operator*(const univariate& a, const univariate& b);
bool is_zero(const univariate& p);
rational evaluate(const univariate& p, const rational& at);

// Returns the distinct real roots, ascending. Requires p not identically zero.
std::vector<algebraic_number> distinct_real_roots(const univariate& p);
// True if the greatest common divisor is a constant: there is no common root, real or complex.
bool are_coprime(const univariate& p, const univariate& q);
// True if no root, real or complex, is multiple.
bool is_square_free(const univariate& p);
// Returns a rational strictly between each two neighbours of a strictly ascending list, one below
// the first and one above the last. n numbers give n+1 samples.
std::vector<rational> samples_between(const std::vector<algebraic_number>& ascending);

}  // namespace asterism::oracle
