// SPDX-License-Identifier: MIT
#include "asterism/kernels/exact_polynomial.hpp"

#include <algorithm>
#include <utility>

namespace asterism::internal::exact {

dense_polynomial::dense_polynomial(std::vector<dyadic> coefficients)
    : coefficients_(std::move(coefficients)) {
  trim();
}

void dense_polynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

sign dense_polynomial::sign_at(const dyadic& x) const {
  if (is_zero()) return sign::zero;
  dyadic value = coefficients_.back();
  for (std::size_t k = degree(); k-- > 0;) value = value * x + coefficients_[k];
  return value.sign_value();
}

dense_polynomial dense_polynomial::derivative() const {
  std::vector<dyadic> result;
  for (std::size_t k = 1; k < coefficients_.size(); ++k)
    result.push_back(coefficients_[k] * dyadic(static_cast<int>(k)));
  return dense_polynomial(std::move(result));
}

void dense_polynomial::make_primitive() {
  if (is_zero()) return;
  // Of the odd parts; the powers of two are dealt with below.
  integer content;
  for (dyadic& c : coefficients_) {
    c.shorten();
    if (c.is_zero()) continue;
    content =
        content.is_zero() ? c.mantissa() : greatest_common_divisor_of_odd(content, c.mantissa());
  }
  if (content.sign_value() == sign::negative) content.negate();
  long shift = 0;
  bool first = true;
  for (const dyadic& c : coefficients_) {
    if (c.is_zero()) continue;
    shift = first ? c.exponent() : std::min(shift, c.exponent());
    first = false;
  }
  for (dyadic& c : coefficients_)
    if (!c.is_zero()) c = dyadic(exact_quotient(c.mantissa(), content), c.exponent() - shift);
}

dense_polynomial remainder(dense_polynomial a, const dense_polynomial& b) {
  const dyadic& lead = b.coefficients_.back();
  const bool flip = lead.sign_value() == sign::negative;
  const dyadic lead_size = flip ? -lead : lead;
  while (!a.is_zero() && a.degree() >= b.degree()) {
    const std::size_t shift = a.degree() - b.degree();
    const dyadic factor = flip ? -a.coefficients_.back() : a.coefficients_.back();
    for (dyadic& c : a.coefficients_) c = c * lead_size;
    for (std::size_t k = 0; k <= b.degree(); ++k)
      a.coefficients_[k + shift] = a.coefficients_[k + shift] - factor * b.coefficients_[k];
    a.trim();
  }
  return a;
}

dense_polynomial exact_quotient(dense_polynomial a, const dense_polynomial& b) {
  const dyadic& lead = b.coefficients_.back();
  std::vector<dyadic> quotient(a.degree() - b.degree() + 1);
  while (!a.is_zero() && a.degree() >= b.degree()) {
    const std::size_t shift = a.degree() - b.degree();
    const dyadic factor = a.coefficients_.back();
    for (dyadic& c : quotient) c = c * lead;
    quotient[shift] = quotient[shift] + factor;
    for (dyadic& c : a.coefficients_) c = c * lead;
    for (std::size_t k = 0; k <= b.degree(); ++k)
      a.coefficients_[k + shift] = a.coefficients_[k + shift] - factor * b.coefficients_[k];
    a.trim();
  }
  dense_polynomial result(std::move(quotient));
  result.make_primitive();
  return result;
}

dense_polynomial greatest_common_divisor(dense_polynomial a, dense_polynomial b) {
  while (!b.is_zero()) {
    dense_polynomial r = a.is_zero() || a.degree() < b.degree() ? a : remainder(a, b);
    r.make_primitive();
    a = std::exchange(b, std::move(r));
  }
  return a;
}

dense_polynomial square_free_part(const dense_polynomial& p) {
  if (p.degree() <= 1) return p;
  const dense_polynomial common = greatest_common_divisor(p, p.derivative());
  return common.degree() == 0 ? p : exact_quotient(p, common);
}

sturm_sequence::sturm_sequence(const dense_polynomial& p) {
  chain_.push_back(p);
  if (p.degree() == 0) return;
  chain_.push_back(p.derivative());
  for (;;) {
    dense_polynomial next = remainder(chain_[chain_.size() - 2], chain_.back());
    if (next.is_zero()) return;
    next.make_primitive();
    std::vector<dyadic> negated;
    for (std::size_t k = 0; k <= next.degree(); ++k) negated.push_back(-next[k]);
    chain_.emplace_back(std::move(negated));
  }
}

int sturm_sequence::variations(const dyadic& x) const {
  int count = 0;
  sign last = sign::zero;
  for (const dense_polynomial& p : chain_) {
    const sign s = p.sign_at(x);
    if (s == sign::zero) continue;
    if (s == -last) ++count;
    last = s;
  }
  return count;
}

int sturm_sequence::roots_between(const dyadic& low, const dyadic& high) const {
  return variations(low) - variations(high);
}

namespace {

// A power of two larger than the absolute value of every root (Cauchy's bound).
dyadic root_bound(const dense_polynomial& p) {
  const long lead = p[p.degree()].magnitude();
  long exponent = 1;
  for (std::size_t k = 0; k < p.degree(); ++k)
    if (!p[k].is_zero()) exponent = std::max(exponent, p[k].magnitude() - lead + 2);
  return dyadic(1).scaled(exponent);
}

struct isolation {
  const dense_polynomial& p;
  sturm_sequence sturm;
  dense_polynomial slope;
  std::vector<real_root> roots;

  sign just_left_of(const dyadic& x) const {
    const sign at = p.sign_at(x);
    return at == sign::zero ? -slope.sign_at(x) : at;
  }

  // Appends the roots in the open interval (low, high), which holds `count` of them.
  void run(const dyadic& low, const dyadic& high, int count) {
    if (count == 0) return;
    if (count == 1) {
      roots.emplace_back(p, low, high, just_left_of(high));
      // Elsewhere an interval's ends are known not to be roots.
      real_root& found = roots.back();
      while (!found.is_dyadic() &&
             (p.sign_at(found.low()) == sign::zero || p.sign_at(found.high()) == sign::zero))
        found.refine();
      return;
    }
    dyadic middle = (low + high).scaled(-1);
    middle.shorten();
    const bool hit = p.sign_at(middle) == sign::zero;
    const int left = sturm.roots_between(low, middle) - (hit ? 1 : 0);
    run(low, middle, left);
    if (hit) roots.emplace_back(p, middle, middle, slope.sign_at(middle));
    run(middle, high, count - left - (hit ? 1 : 0));
  }
};

bool overlap(const real_root& a, const real_root& b) {
  // Two open intervals that share only an end hold different roots; a dyadic root at the open end
  // of an interval is not that interval's root.
  return a.low() < b.high() && b.low() < a.high();
}

}  // namespace

std::vector<real_root> isolate_real_roots(const dense_polynomial& polynomial) {
  if (polynomial.degree() == 0) return {};
  dense_polynomial p = square_free_part(polynomial);
  p.make_primitive();
  isolation work{p, sturm_sequence(p), p.derivative(), {}};
  const dyadic bound = root_bound(p);
  work.run(-bound, bound, work.sturm.roots_between(-bound, bound));
  return std::move(work.roots);
}

void real_root::refine() {
  if (is_dyadic()) return;
  dyadic middle = (low_ + high_).scaled(-1);
  middle.shorten();
  const sign s = p_.sign_at(middle);
  if (s == sign::zero)
    low_ = high_ = middle;
  else
    (s == right_ ? high_ : low_) = middle;
}

bool real_root::is_root_of(const dense_polynomial& q) const {
  if (is_dyadic()) return q.sign_at(low_) == sign::zero;
  const dense_polynomial common = greatest_common_divisor(p_, q);
  if (common.degree() == 0) return false;
  // A root of the divisor is one of p, which has only this one in the interval and none at its
  // ends.
  return sturm_sequence(common).roots_between(low_, high_) != 0;
}

sign real_root::sign_of_value(const dense_polynomial& q) {
  if (q.is_zero() || is_root_of(q)) return sign::zero;
  if (q.degree() == 0) return q[0].sign_value();
  const sturm_sequence sturm(q);
  while (!is_dyadic() && (sturm.roots_between(low_, high_) != 0 || q.sign_at(low_) == sign::zero))
    refine();
  return q.sign_at(low_);
}

sign compare(real_root& a, real_root& b) {
  constexpr int cheap_rounds = 6;  // of bisection, before equality is looked into
  for (int round = 0;; ++round) {
    if (a.is_dyadic() && b.is_dyadic()) return (a.low_ - b.low_).sign_value();
    if (!overlap(a, b))
      return a.high_ < b.low_ || a.high_ == b.low_ ? sign::negative : sign::positive;
    if (round == cheap_rounds) {
      // Each interval holds one root of its own polynomial: a common root in the overlap is both.
      const real_root& narrow = a.high_ - a.low_ < b.high_ - b.low_ ? a : b;
      const real_root& other = &narrow == &a ? b : a;
      if (narrow.is_root_of(other.p_)) {
        real_root probe = narrow;
        while (overlap(probe, other) && !probe.is_dyadic() &&
               (probe.low_ < other.low_ || other.high_ < probe.high_))
          probe.refine();
        if (overlap(probe, other) ||
            (probe.is_dyadic() && other.is_dyadic() && probe.low_ == other.low_))
          return sign::zero;
      }
    }
    a.refine();
    b.refine();
  }
}

}  // namespace asterism::internal::exact
