// SPDX-License-Identifier: MIT
//
// Curves of degree at most two, by coefficients, with the classical constructions on them (polar,
// pair of tangents). Two-site bisectors are such curves: Vor{v,w} = { f_v - f_w = 0 }.
#pragma once

#include "exact_numbers.hpp"

namespace asterism::oracle {

// xx X^2 + xy X Y + yy Y^2 + x X + y Y + constant
struct conic {
  rational xx{0}, xy{0}, yy{0}, x{0}, y{0}, constant{0};

  template <class Number>
  Number at(const basic_point<Number>& q) const {
    return q.x * (Number(xx) * q.x + Number(xy) * q.y + Number(x)) +
           q.y * (Number(yy) * q.y + Number(y)) + Number(constant);
  }
};

conic operator-(const conic& a, const conic& b);
conic operator*(const rational& factor, const conic& a);

// f_s
conic squared_distance(const exact_site& s);
// f_v - f_w
conic bisector(const exact_site& v, const exact_site& w);

// The functions below return lines as conics without a quadratic part.
conic line_through(const basic_point<rational>& p, const basic_point<rational>& q);
// Returns the polar of p: the line through the points where tangents from p touch the curve.
conic polar_line(const conic& g, const basic_point<rational>& p);
// Returns the tangents to the curve from p, as one curve of degree two: g(p) g - polar^2.
conic tangent_pair(const conic& g, const basic_point<rational>& p);

}  // namespace asterism::oracle
