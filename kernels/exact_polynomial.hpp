// SPDX-License-Identifier: MIT
//
// Computes with polynomials with dyadic coefficients and their real roots, exactly: Sturm
// sequences, isolation by bisection, comparison of roots through greatest common divisors. Degrees
// here are at most four, so plain algorithms do.
#pragma once

#include <vector>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/polynomial.hpp"

namespace asterism::internal::exact {

// Coefficients of x^0, x^1, ...; the last one is not zero; the list of the zero polynomial is
// empty.
class dense_polynomial {
 public:
  dense_polynomial() = default;
  explicit dense_polynomial(std::vector<dyadic> coefficients);
  template <std::size_t Degree>
  explicit dense_polynomial(const polynomial<dyadic, Degree>& p)
      : dense_polynomial(std::vector<dyadic>(p.coefficient.begin(), p.coefficient.end())) {}

  bool is_zero() const { return coefficients_.empty(); }
  // Requires a polynomial that is not zero.
  std::size_t degree() const { return coefficients_.size() - 1; }
  const dyadic& operator[](std::size_t k) const { return coefficients_[k]; }
  dyadic value_at(const dyadic& x) const;
  sign sign_at(const dyadic& x) const { return value_at(x).sign_value(); }
  dense_polynomial derivative() const;
  // Divides the coefficients by their common positive factor, which keeps the roots.
  void make_primitive();

  // Return a positive multiple of the remainder, and a multiple, of either sign, of the quotient.
  friend dense_polynomial remainder(dense_polynomial a, const dense_polynomial& b);
  friend dense_polynomial exact_quotient(dense_polynomial a, const dense_polynomial& b);

 private:
  void trim();
  std::vector<dyadic> coefficients_;
};

dense_polynomial greatest_common_divisor(dense_polynomial a, dense_polynomial b);
dense_polynomial square_free_part(const dense_polynomial& p);

// Returns the number of distinct real roots in (low, high], by Sturm's theorem.
class sturm_sequence {
 public:
  explicit sturm_sequence(const dense_polynomial& p);
  int roots_between(const dyadic& low, const dyadic& high) const;

 private:
  int variations(const dyadic& x) const;
  std::vector<dense_polynomial> chain_;
};

// One real root: `low` itself when low == high, else the only root of the square-free `p` in [low,
// high], whose ends are not roots.
class real_root {
 public:
  real_root(dense_polynomial p, dyadic low, dyadic high, sign right_of_root)
      : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)), right_(right_of_root) {}

  const dyadic& low() const { return low_; }
  const dyadic& high() const { return high_; }
  bool is_dyadic() const { return low_ == high_; }
  const dense_polynomial& defining() const { return p_; }
  // Shrinks the interval: at least by half in the end, by up to 2^48 where the secant locates the
  // root (Abbott, Quadratic interval refinement, 2006).
  void refine();
  // Returns the exact sign of q at this root. Shrinks the interval.
  sign sign_of_value(const dense_polynomial& q);

  // Returns the sign of a - b. Shrinks both intervals.
  friend sign compare(real_root& a, real_root& b);

 private:
  bool is_root_of(const dense_polynomial& q) const;
  void split_at(const dyadic& x);
  bool narrow_to_cell(int bits);

  dense_polynomial p_;
  dyadic low_, high_;
  sign right_;           // sign of p just right of the root
  int secant_bits_ = 2;  // how far the secant is trusted next
};

// Returns every distinct real root in increasing order. Requires p not zero.
std::vector<real_root> isolate_real_roots(const dense_polynomial& p);

}  // namespace asterism::internal::exact
