// SPDX-License-Identifier: MIT
//
// Defines interval arithmetic on doubles whose ends are rounded outward. Every operation must be in
// a floating_point_scope(rounding::upward), in a function that is not inlined into the one that
// holds the scope, and is compiled with -frounding-math. Where there is no directed rounding, each
// end that was rounded inward is moved outward by one unit: the same ends (core/two_lanes.hpp).
//
// Stores [low, high] as the pair {-low, high}. Rounding upward then widens at both ends, because
// -low rounded up is minus low rounded down, and no operation has to change the rounding mode.
// Source: Lambov, "Interval arithmetic using SSE-2", Reliable Implementation of Real Number
// Algorithms, LNCS 5045, 2008.
//
// Guarantee: for real numbers x in a and y in b, the result of an operation on a and b encloses the
// result of the operation on x and y. Each end is the least or greatest such number, correctly
// rounded, as long as no end of a or b is infinite.
//
// An infinite end means "no bound". It only ever points outward: rounded up, -low and high overflow
// to plus infinity and never to minus infinity. A sum therefore never adds opposite infinities, and
// the one NaN that can arise is zero times infinity in a product, which is dealt with there.
#pragma once

// Included first, as it refuses -ffast-math, for which nothing below would be rigorous.
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/two_lanes.hpp"

namespace asterism::internal {

class rounded_interval {
 public:
  rounded_interval() : rounded_interval(0.0) {}
  rounded_interval(int value) : rounded_interval(static_cast<double>(value)) {}
  rounded_interval(double value) : ends_(-value, value) {}
  // Requires low <= high, low finite or minus infinity, high finite or plus infinity.
  rounded_interval(double low, double high) : ends_(-low, high) {}

  double inf() const { return -ends_.first(); }
  double sup() const { return ends_.second(); }

  friend rounded_interval operator+(const rounded_interval& a, const rounded_interval& b) {
    return rounded_interval(rounded_sum(a.ends_, b.ends_));
  }
  rounded_interval operator-() const { return rounded_interval(ends_.swapped()); }
  friend rounded_interval operator-(const rounded_interval& a, const rounded_interval& b) {
    return a + -b;
  }
  friend rounded_interval operator*(const rounded_interval& a, const rounded_interval& b);

  // Returns { x^2 : x in a }, whose lower end is zero where a straddles zero.
  friend rounded_interval squared(const rounded_interval& a);
  // Returns the square roots of the part of a that is not negative. Requires a.sup() >= 0.
  friend rounded_interval root_of_non_negative(const rounded_interval& a);

 private:
  explicit rounded_interval(const two_lanes& ends) : ends_(ends) {}

  two_lanes ends_;  // {-low, high}
};

// Computes the upper end as the greatest of the four products of ends, and minus the lower end is
// the greatest of their negatives.
//
// A product of an end zero and an infinite end is NaN and stands for zero, since every number of an
// interval is finite. `greatest` gives its second operand when one is NaN. The second operands are
// made infinite where they are NaN, which widens; a first operand that is NaN is dropped. Dropping
// loses nothing: the zero end times the other end of the other factor stands in the same lane and
// is zero or was made infinite, and where it is itself a dropped one, both ends of the other factor
// are infinite and a kept product of the lane is infinite too.
inline rounded_interval operator*(const rounded_interval& a, const rounded_interval& b) {
  const two_lanes u = opaque(a.ends_);                         // {-al, ah}
  const two_lanes minus_u = u.swapped().negated();             // {-ah, al}
  const two_lanes v = opaque_here(b.ends_.first_negated());    // {bl, bh}
  const two_lanes crossed = v.swapped();                       // {bh, bl}
  const two_lanes same = product(u, v);                        // {-al bl, ah bh}
  const two_lanes mixed = not_nan(product(u, crossed));        // {-al bh, ah bl}
  const two_lanes other_mixed = product(minus_u, v);           // {-ah bl, al bh}
  const two_lanes other = not_nan(product(minus_u, crossed));  // {-ah bh, al bl}
  return rounded_interval(
      opaque_here(greatest(greatest(same, mixed), greatest(other_mixed, other))));
}

inline rounded_interval squared(const rounded_interval& a) {
  const two_lanes ends = opaque_here(a.ends_), swapped = ends.swapped();
  const two_lanes most = greatest(ends, swapped);  // the greatest modulus, in both lanes
  // Takes minus the least modulus, in both lanes; zero where the interval straddles zero.
  const two_lanes least = smallest(smallest(ends, swapped), two_lanes(0.0, 0.0));
  const two_lanes factor = first_then_second(least, most);
  return rounded_interval(opaque_here(product(factor, factor.first_negated())));
}

// Returns the root of x rounded down. Upward, root is the least double r with r >= sqrt(x), and r *
// r gives x only when it is no more than x, that is when r is the root itself; else the double
// below r lies below it. That is minus the sum of -r and the least positive double, rounded upward.
inline double root_rounded_down(double x) {
  const double root = rounded_root(x);
  if (rounded_product(root, root) == x) return root;
  return -rounded_sum(-root, 0x1p-1074);
}

inline rounded_interval root_of_non_negative(const rounded_interval& a) {
  const double low = a.inf() > 0 ? root_rounded_down(a.inf()) : 0;
  return rounded_interval(low, rounded_root(a.sup()));
}

}  // namespace asterism::internal
