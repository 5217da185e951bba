// SPDX-License-Identifier: MIT
//
// Defines exact numbers a + b sqrt(c) with one common radicand c >= 0: the coordinates of a point
// of a visible arc at a dyadic parameter (predicates/visible_arc.hpp). Closed under +, -, *; the
// sign needs integers alone.
#pragma once

#include <cassert>
#include <utility>

#include "asterism/core/dyadic.hpp"

namespace asterism::internal {

using asterism::sign_of;  // of a double, beside those below

class square_root_sum {
 public:
  square_root_sum() = default;
  square_root_sum(dyadic a) : a_(std::move(a)) {}
  square_root_sum(int a) : a_(a) {}
  // `radicand` is shared, not owned: it must outlive every number computed from this one, and
  // numbers with different radicands must not meet.
  square_root_sum(dyadic a, dyadic b, const dyadic& radicand)
      : a_(std::move(a)), b_(std::move(b)), radicand_(&radicand) {}

  friend square_root_sum operator+(const square_root_sum& p, const square_root_sum& q) {
    return {p.a_ + q.a_, p.b_ + q.b_, common(p, q)};
  }
  friend square_root_sum operator-(const square_root_sum& p, const square_root_sum& q) {
    return {p.a_ - q.a_, p.b_ - q.b_, common(p, q)};
  }
  friend square_root_sum operator*(const square_root_sum& p, const square_root_sum& q) {
    if (q.b_.is_zero()) return {p.a_ * q.a_, p.b_ * q.a_, common(p, q)};
    if (p.b_.is_zero()) return {p.a_ * q.a_, p.a_ * q.b_, common(p, q)};
    return {p.a_ * q.a_ + p.b_ * q.b_ * *p.radicand_, p.a_ * q.b_ + p.b_ * q.a_, common(p, q)};
  }
  square_root_sum operator-() const { return {-a_, -b_, radicand_}; }

  sign sign_value() const {
    const sign sa = a_.sign_value();
    if (b_.is_zero() || radicand_->is_zero()) return sa;
    const sign sb = b_.sign_value();
    if (sa == sb || sa == sign::zero) return sb;
    return sa * (a_ * a_ - b_ * b_ * *radicand_).sign_value();
  }

 private:
  square_root_sum(dyadic a, dyadic b, const dyadic* radicand)
      : a_(std::move(a)), b_(std::move(b)), radicand_(radicand) {}
  static const dyadic* common(const square_root_sum& p, const square_root_sum& q) {
    assert(!p.radicand_ || !q.radicand_ || p.radicand_ == q.radicand_);
    return p.radicand_ ? p.radicand_ : q.radicand_;
  }

  dyadic a_, b_;
  const dyadic* radicand_ = nullptr;
};

inline uncertain_sign sign_of(const square_root_sum& x) { return x.sign_value(); }

}  // namespace asterism::internal
