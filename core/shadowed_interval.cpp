// SPDX-License-Identifier: MIT
#include "asterism/core/shadowed_interval.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

namespace asterism::internal {

namespace {

bool is_number(double x) {
  constexpr double largest = std::numeric_limits<double>::max();
  return x >= -largest && x <= largest;
}

dyadic_range exactly(const dyadic& x) { return {x, x, true}; }

dyadic_range operator+(const dyadic_range& a, const dyadic_range& b) {
  if (a.exact && b.exact) return exactly(a.low + b.low);
  return {a.low + b.low, a.high + b.high, false};
}

dyadic_range operator-(const dyadic_range& a) { return {-a.high, -a.low, a.exact}; }

const dyadic& least(const dyadic& a, const dyadic& b) { return b < a ? b : a; }
const dyadic& greatest(const dyadic& a, const dyadic& b) { return a < b ? b : a; }

dyadic_range operator*(const dyadic_range& a, const dyadic_range& b) {
  if (a.exact && b.exact) return exactly(a.low * b.low);
  const std::array<dyadic, 4> products = {a.low * b.low, a.low * b.high, a.high * b.low,
                                          a.high * b.high};
  return {least(least(products[0], products[1]), least(products[2], products[3])),
          greatest(greatest(products[0], products[1]), greatest(products[2], products[3])), false};
}

dyadic_range least(const dyadic_range& a, const dyadic_range& b) {
  return {least(a.low, b.low), least(a.high, b.high), a.exact && b.exact};
}
dyadic_range greatest(const dyadic_range& a, const dyadic_range& b) {
  return {greatest(a.low, b.low), greatest(a.high, b.high), a.exact && b.exact};
}

// Returns the square root of x > 0: exact, or between two dyadic numbers that differ by one unit in
// the last of at least 400 bits.
dyadic_range square_root(const dyadic& x) {
  constexpr long bits = 800;
  long shift = std::max(0L, bits - (x.magnitude() - x.exponent()));
  if ((x.exponent() - shift) % 2 != 0) ++shift;
  integer radicand = x.mantissa();
  radicand.shift_up(static_cast<unsigned long>(shift));
  bool exact = false;
  const integer root = square_root(radicand, exact);
  const long exponent = (x.exponent() - shift) / 2;
  const dyadic low(root, exponent);
  if (exact) return exactly(low);
  return {low, low + dyadic(1).scaled(exponent), false};
}

// Returns the square root of x, or of 0 where x is negative.
dyadic_range root_of_non_negative(const dyadic_range& x) {
  const auto positive = [](const dyadic& y) { return y.sign_value() == sign::positive; };
  dyadic_range low = positive(x.low) ? square_root(x.low) : exactly(dyadic(0));
  if (x.exact) return low;
  const dyadic_range high = positive(x.high) ? square_root(x.high) : exactly(dyadic(0));
  return {low.low, high.high, false};
}

}  // namespace

shadowed_interval::shadowed_interval(double low, double high) : box_(low, high) {
  if (is_number(low) && is_number(high))
    shadow_ = ends{exactly(dyadic(low)), exactly(dyadic(high)), low == high};
}

shadowed_interval::shadowed_interval(const char* operation, const enclosure& box,
                                     std::optional<ends> shadow)
    : box_(box), shadow_(std::move(shadow)) {
  check(operation);
}

void shadowed_interval::check(const char* operation) const {
  if (!shadow_) return;
  // Checks an end: an infinite end encloses all numbers on its side; a NaN encloses none.
  const bool below = !is_number(inf()) || !(shadow_->least.high < dyadic(inf()));
  const bool above = !is_number(sup()) || !(dyadic(sup()) < shadow_->greatest.low);
  if (below && above) return;
  std::fprintf(stderr, "self-check: the exact result of a %s lies outside [%a, %a], %s\n",
               operation, inf(), sup(), below ? "above" : "below");
  std::abort();
}

shadowed_interval operator+(const shadowed_interval& a, const shadowed_interval& b) {
  std::optional<shadowed_interval::ends> shadow;
  if (a.shadow_ && b.shadow_)
    shadow = {a.shadow_->least + b.shadow_->least, a.shadow_->greatest + b.shadow_->greatest,
              a.shadow_->point && b.shadow_->point};
  return {"sum", a.box_ + b.box_, std::move(shadow)};
}

shadowed_interval operator-(const shadowed_interval& a, const shadowed_interval& b) {
  std::optional<shadowed_interval::ends> shadow;
  if (a.shadow_ && b.shadow_)
    shadow = {a.shadow_->least + -b.shadow_->greatest, a.shadow_->greatest + -b.shadow_->least,
              a.shadow_->point && b.shadow_->point};
  return {"difference", a.box_ - b.box_, std::move(shadow)};
}

shadowed_interval operator*(const shadowed_interval& a, const shadowed_interval& b) {
  std::optional<shadowed_interval::ends> shadow;
  if (a.shadow_ && b.shadow_) {
    const auto &p = *a.shadow_, &q = *b.shadow_;
    const dyadic_range first = p.least * q.least;
    if (p.point && q.point) {
      shadow = {first, first, true};
    } else {
      const dyadic_range second = p.least * q.greatest, third = p.greatest * q.least,
                         fourth = p.greatest * q.greatest;
      shadow = {least(least(first, second), least(third, fourth)),
                greatest(greatest(first, second), greatest(third, fourth)), false};
    }
  }
  return {"product", a.box_ * b.box_, std::move(shadow)};
}

shadowed_interval shadowed_interval::operator-() const {
  std::optional<ends> shadow;
  if (shadow_) shadow = {-shadow_->greatest, -shadow_->least, shadow_->point};
  return {"negation", -box_, std::move(shadow)};
}

shadowed_interval squared(const shadowed_interval& a) {
  std::optional<shadowed_interval::ends> shadow;
  if (a.shadow_) {
    const auto& p = *a.shadow_;
    const dyadic_range first = p.least * p.least, second = p.greatest * p.greatest;
    // Takes 0 as the least square only where both bounds of the operand prove that 0 lies between
    // its ends.
    const bool straddles = p.least.high.sign_value() != sign::positive &&
                           p.greatest.low.sign_value() != sign::negative;
    shadow = {straddles ? exactly(dyadic(0)) : least(first, second), greatest(first, second),
              p.point};
  }
  return {"square", squared(a.box_), std::move(shadow)};
}

shadowed_interval root_of_non_negative(const shadowed_interval& a) {
  std::optional<shadowed_interval::ends> shadow;
  if (a.shadow_) {
    const auto& p = *a.shadow_;
    const dyadic_range low = root_of_non_negative(p.least), high = root_of_non_negative(p.greatest);
    shadow = {low, high, p.point && low.exact};
  }
  return {"square root", root_of_non_negative(a.box_), std::move(shadow)};
}

}  // namespace asterism::internal
