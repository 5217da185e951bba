// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/interval_functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/rounded_quotient.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
// Bounds of the errors of core/elementary, as derived in interval_functions.hpp: relative for
// normal results, absolute for subnormal ones.
constexpr double elementary_error = 0x1p-49, subnormal_error = 0x1p-1070;

using plain_function = double (*)(double);

// Returns the function's value in the rounding mode in which core/elementary is accurate.
[[gnu::noinline]] double value_to_nearest(plain_function f, double x) {
  const floating_point_scope scope(rounding::nearest);
  return opaque_here(f(opaque_here(x)));
}

// Returns a bound of the function's value: a lower one for `down`, else an upper one.
double value_outward(plain_function f, double x, bool down) {
  const double y = value_to_nearest(f, x);
  if (!(std::abs(y) <= largest)) return y;
  const double margin =
      rounded_sum(rounded_product(std::abs(y), elementary_error), subnormal_error);
  return down ? -rounded_sum(-y, margin) : rounded_sum(y, margin);
}

// Encloses the values of a function that increases.
rounded_interval increasing(plain_function f, const rounded_interval& a) {
  const double low = value_outward(f, a.inf(), true), high = value_outward(f, a.sup(), false);
  // Replaces an end beyond the range of doubles by the largest double: infinity would be no bound.
  return {low == infinity ? largest : low, high == -infinity ? -largest : high};
}

double tangent_inverse(double x) { return elementary::atan2(x, 1); }

// False only if the interval is without a point (k + shift) pi with k of the given parity: there a
// wave is greatest (parity 0) or least (parity 1). Tests five values of k, as the interval is
// shorter than 2 pi.
bool may_have_crest(const rounded_interval& a, double shift, int parity) {
  const double first = std::floor(a.inf() / std::numbers::pi - shift) - 1;
  for (int step = 0; step < 5; ++step) {
    const double k = first + step;
    if (std::abs(std::fmod(k, 2)) != parity) continue;
    // Widens the interval by 2^-40 of 1 + |at|: the roundings of `at`, of pi and of both
    // comparisons are together below 2^-50 of that.
    const double at = (k + shift) * std::numbers::pi, slack = 0x1p-40 * (1 + std::abs(at));
    if (at >= a.inf() - slack && at <= a.sup() + slack) return true;
  }
  return false;
}

// Encloses a sine (`shift` 1/2: greatest at pi/2) or a cosine (0).
rounded_interval wave(plain_function f, const rounded_interval& a, double shift) {
  // Limits of the length and the place of an interval that is enclosed sharply: beyond them
  // multiples of pi are not distinguished, and [-1, 1] is returned, which encloses all values.
  constexpr double longest = 6, farthest = 0x1p20;
  if (!(a.sup() - a.inf() < longest) || !(std::abs(a.inf()) < farthest)) return {-1, 1};
  const rounded_interval from = {value_outward(f, a.inf(), true), value_outward(f, a.inf(), false)},
                         to = {value_outward(f, a.sup(), true), value_outward(f, a.sup(), false)};
  const rounded_interval both = hull(from, to);
  const double low = may_have_crest(a, shift, 1) ? -1 : std::max(both.inf(), -1.0);
  const double high = may_have_crest(a, shift, 0) ? 1 : std::min(both.sup(), 1.0);
  return {low, high};
}

// Returns the functions at one point, both enclosed. For q below 1 they are sums of series with
// positive terms: the rest after q^9 is less than twice the next term.
even_functions even_functions_at(double at) {
  const rounded_interval q = at;
  if (at >= 1) {
    const rounded_interval r = root_of(q), up = exponential_of(r), down = exponential_of(-r),
                           half = 0.5;
    const rounded_interval c = half * (up + down), s = divided(half * (up - down), r);
    return {c, s, divided(c - s, q + q)};
  }
  // Sums the terms of q^k: 1 / (2k)! of C, 1 / (2k+1)! of S, (k+1) / (2k+3)! of S'.
  rounded_interval power = 1, c = 0, s = 0, slope = 0;
  rounded_interval factorial = 1;  // (2k)!
  constexpr int terms = 10;
  for (int k = 0; k < terms; ++k) {
    const rounded_interval odd = factorial * rounded_interval(2 * k + 1),
                           even = odd * rounded_interval(2 * k + 2),
                           next_odd = even * rounded_interval(2 * k + 3);
    c = c + divided(power, factorial);
    s = s + divided(power, odd);
    slope = slope + divided(power * rounded_interval(k + 1), next_odd);
    power = power * q;
    factorial = even;
  }
  // Bounds the terms left out of each series: 20! is above 2^61, and each term is less than half of
  // the one before.
  const rounded_interval rest(0, 0x1p-59);
  return {c + rest, s + rest, slope + rest};
}

}  // namespace

rounded_interval everything() { return {-infinity, infinity}; }

bool is_bounded(const rounded_interval& a) { return a.inf() >= -largest && a.sup() <= largest; }

rounded_interval divided(const rounded_interval& a, const rounded_interval& b) {
  if (b.inf() > 0) return is_bounded(a) ? quotient(a, b) : everything();
  if (b.sup() < 0) return is_bounded(a) ? quotient(-a, -b) : everything();
  return everything();
}

rounded_interval root_of(const rounded_interval& a) {
  return a.sup() >= 0 ? root_of_non_negative(a) : rounded_interval(0);
}

rounded_interval exponential_of(const rounded_interval& a) {
  const rounded_interval e = increasing(&elementary::exp, a);
  return {std::max(e.inf(), 0.0), e.sup()};
}

rounded_interval logarithm_of(const rounded_interval& a) {
  if (!(a.inf() > 0)) {
    if (!(a.sup() > 0)) return everything();
    return {-infinity, increasing(&elementary::log, a.sup()).sup()};
  }
  return increasing(&elementary::log, a);
}

rounded_interval sine_of(const rounded_interval& a) { return wave(&elementary::sin, a, 0.5); }
rounded_interval cosine_of(const rounded_interval& a) { return wave(&elementary::cos, a, 0); }

rounded_interval hyperbolic_tangent_of(const rounded_interval& a) {
  const rounded_interval t = increasing(&elementary::tanh, a);
  return {std::max(t.inf(), -1.0), std::min(t.sup(), 1.0)};
}

rounded_interval arc_tangent_of(const rounded_interval& a) {
  return increasing(&tangent_inverse, a);
}

even_functions even_functions_of(const rounded_interval& q) {
  const even_functions low = even_functions_at(q.inf());
  if (q.sup() == q.inf()) return low;
  const even_functions high = even_functions_at(q.sup());
  return {{low.cosh.inf(), high.cosh.sup()},
          {low.sinhc.inf(), high.sinhc.sup()},
          {low.slope.inf(), high.slope.sup()}};
}

}  // namespace asterism::internal
