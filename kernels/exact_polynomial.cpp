// SPDX-License-Identifier: MIT
#include "asterism/kernels/exact_polynomial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace asterism::internal::exact {

dense_polynomial::dense_polynomial(std::vector<dyadic> coefficients)
    : coefficients_(std::move(coefficients)) {
  trim();
}

void dense_polynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

dyadic dense_polynomial::value_at(const dyadic& x) const {
  if (is_zero()) return {};
  dyadic value = coefficients_.back();
  for (std::size_t k = degree(); k-- > 0;) value = value * x + coefficients_[k];
  return value;
}

dense_polynomial dense_polynomial::derivative() const {
  std::vector<dyadic> result;
  for (std::size_t k = 1; k < coefficients_.size(); ++k)
    result.push_back(coefficients_[k] * dyadic(static_cast<int>(k)));
  return dense_polynomial(std::move(result));
}

void dense_polynomial::make_primitive() {
  if (is_zero()) return;
  // Returns the greatest common divisor of the odd parts; powers of two are handled separately.
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

// Returns a power of two larger than the absolute value of every root (Cauchy's bound).
dyadic root_bound(const dense_polynomial& p) {
  const long lead = p[p.degree()].magnitude();
  long exponent = 1;
  for (std::size_t k = 0; k < p.degree(); ++k)
    if (!p[k].is_zero()) exponent = std::max(exponent, p[k].magnitude() - lead + 2);
  return dyadic(1).scaled(exponent);
}

// Returns |x| 2^-magnitude, in [1/2, 1], to about 2^-60. Requires a value that is not zero.
double leading_fraction(const dyadic& x) {
  const auto limbs = x.mantissa().limbs();
  const double low = limbs.size() > 1 ? static_cast<double>(limbs[limbs.size() - 2]) * 0x1p-64 : 0;
  const double value = static_cast<double>(limbs.back()) + low;
  return std::ldexp(value, -static_cast<int>(std::bit_width(limbs.back())));
}

// Returns a short number strictly between low and high: the power of two with the mean of their
// exponents while the exponents differ, then the mean of the two. Halving alone would take one step
// for each exponent in between.
dyadic split_point(const dyadic& low, const dyadic& high) {
  const sign side_low = low.sign_value(), side_high = high.sign_value();
  if (side_low == sign::negative && side_high == sign::positive) return dyadic(0);
  const bool below = side_high != sign::positive;
  const dyadic near = below ? -high : low, far = below ? -low : high;
  const long most = far.magnitude();
  // Handles intervals that begin at zero, where exponents have no lower limit: takes the middle of
  // a range of at least 64 exponents, which grows as the interval shrinks.
  const long least = near.is_zero() ? most - std::max(64L, std::abs(most)) : near.magnitude();
  if (most - least > 2) {
    const dyadic middle = dyadic(1).scaled(least + (most - least) / 2);
    return below ? -middle : middle;
  }
  dyadic middle = (low + high).scaled(-1);
  middle.shorten();
  return middle;
}

struct isolation {
  const dense_polynomial& p;
  sturm_sequence sturm;
  dense_polynomial slope;
  std::vector<real_root> roots;
  std::optional<std::vector<real_root>> turns;  // of the slope; made when needed

  sign just_left_of(const dyadic& x) const {
    const sign at = p.sign_at(x);
    return at == sign::zero ? -slope.sign_at(x) : at;
  }

  // Appends the roots in the open interval (low, high), which holds `count` of them.
  void run(const dyadic& low, const dyadic& high, int count, int splits = 0) {
    if (count == 0) return;
    if (count == 1) {
      roots.emplace_back(p, low, high, just_left_of(high));
      // Shrinks the interval until neither end is a root. All other intervals of roots have such
      // ends from the start.
      real_root& found = roots.back();
      while (!found.is_dyadic() &&
             (p.sign_at(found.low()) == sign::zero || p.sign_at(found.high()) == sign::zero))
        found.refine();
      return;
    }
    constexpr int most_splits = 24;
    std::vector<dyadic> cuts;
    if (splits > most_splits) cuts = beside_turns(low, high);
    if (cuts.empty()) cuts.push_back(split_point(low, high));
    dyadic from = low;
    for (const dyadic& cut : cuts) {
      const bool hit = p.sign_at(cut) == sign::zero;
      const int between = sturm.roots_between(from, cut) - (hit ? 1 : 0);
      run(from, cut, between, splits + 1);
      if (hit) roots.emplace_back(p, cut, cut, slope.sign_at(cut));
      count -= between + (hit ? 1 : 0);
      from = cut;
    }
    run(from, high, count, splits + 1);
  }

  // Returns cuts for roots that bisection separates slowly: the ends of short intervals around
  // roots of the derivative. Between two roots lies a root of the derivative, whose interval is
  // found fast.
  std::vector<dyadic> beside_turns(const dyadic& low, const dyadic& high) {
    if (!turns) turns = isolate_real_roots(slope);
    const long narrow = (high - low).magnitude() - 32;
    std::vector<dyadic> cuts;
    const auto add = [&](const dyadic& x) {
      if (low < x && x < high && (cuts.empty() || cuts.back() < x)) cuts.push_back(x);
    };
    for (real_root& turn : *turns) {
      while (!turn.is_dyadic() && turn.low() < high && low < turn.high() &&
             (turn.high() - turn.low()).magnitude() > narrow)
        turn.refine();
      add(turn.low());
      add(turn.high());
    }
    return cuts;
  }
};

// Returns |a| / (|a| + |b|), approximately.
double share_of_first(const dyadic& a, const dyadic& b) {
  if (a.is_zero()) return 0;
  if (b.is_zero()) return 1;
  const long apart = a.magnitude() - b.magnitude();
  if (std::abs(apart) > 1000) return apart > 0 ? 1 : 0;
  const double ratio =
      std::ldexp(leading_fraction(a) / leading_fraction(b), static_cast<int>(apart));
  return ratio / (1 + ratio);
}

bool overlap(const real_root& a, const real_root& b) {
  // Returns false only for different roots: open intervals that share at most an end hold different
  // roots, and a dyadic root at an open end of an interval is not that interval's root.
  return a.low() < b.high() && b.low() < a.high();
}

}  // namespace

std::vector<real_root> isolate_real_roots(const dense_polynomial& polynomial) {
  if (polynomial.degree() == 0) return {};
  dense_polynomial p = square_free_part(polynomial);
  p.make_primitive();
  isolation work{p, sturm_sequence(p), p.derivative(), {}, {}};
  const dyadic bound = root_bound(p);
  work.run(-bound, bound, work.sturm.roots_between(-bound, bound));
  return std::move(work.roots);
}

void real_root::split_at(const dyadic& x) {
  const sign s = p_.sign_at(x);
  if (s == sign::zero)
    low_ = high_ = x;
  else
    (s == right_ ? high_ : low_) = x;
}

void real_root::refine() {
  constexpr int most_bits = 48;
  if (is_dyadic()) return;
  const bool ends_are_near = low_.sign_value() * high_.sign_value() == sign::positive &&
                             std::abs(low_.magnitude() - high_.magnitude()) <= 2;
  if (!ends_are_near || secant_bits_ < 2) {
    split_at(split_point(low_, high_));
    secant_bits_ = 2;
  } else {
    secant_bits_ =
        narrow_to_cell(secant_bits_) ? std::min(2 * secant_bits_, most_bits) : secant_bits_ / 2;
  }
}

// Narrows the interval, divided into 2^bits cells, to the cell that contains the secant's root.
// True if that cell contains the root, or the root was hit exactly.
bool real_root::narrow_to_cell(int bits) {
  const double share = share_of_first(p_.value_at(low_), p_.value_at(high_));
  const double cells = std::ldexp(1.0, bits);
  const double cell = std::fmin(std::floor(share * cells), cells - 1);
  const dyadic step = (high_ - low_).scaled(-bits);
  dyadic left = low_ + step * dyadic(cell), right = left + step;
  left.shorten();
  right.shorten();
  if (cell > 0) split_at(left);
  if (is_dyadic() || !(low_ == left)) return is_dyadic();
  if (cell + 1 < cells) split_at(right);
  return is_dyadic() || high_ == right;
}

bool real_root::is_root_of(const dense_polynomial& q) const {
  if (is_dyadic()) return q.sign_at(low_) == sign::zero;
  const dense_polynomial common = greatest_common_divisor(p_, q);
  if (common.degree() == 0) return false;
  // Uses that a root of the divisor is a root of p, and that p has one root in the interval and
  // none at its ends.
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
      // Uses that each interval holds one root of its own polynomial: a common root in the overlap
      // is the root of both.
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
