// SPDX-License-Identifier: MIT
//
// Defines vectors of three numbers and points with weights, in doubles, in intervals and exactly.
// Intervals require a floating_point_scope(rounding::upward).
#pragma once

#include <algorithm>
#include <array>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/rounded_interval.hpp"
#include "asterism/core/rounded_quotient.hpp"
#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

template <class Number>
struct space_vector {
  Number x, y, z;

  friend space_vector operator+(const space_vector& a, const space_vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend space_vector operator-(const space_vector& a, const space_vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend space_vector operator*(const Number& s, const space_vector& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
};

template <class Number>
Number dot(const space_vector<Number>& a, const space_vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
space_vector<Number> cross(const space_vector<Number>& a, const space_vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using plain_vector = space_vector<double>;
using interval_vector = space_vector<rounded_interval>;
using exact_vector = space_vector<dyadic>;

inline plain_vector plain(const space_point& p) { return {p.x, p.y, p.z}; }
template <class Number>
space_vector<Number> vector_of(const space_point& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

inline double middle_of(const rounded_interval& a) { return (a.inf() + a.sup()) / 2; }
inline plain_vector middle_of(const interval_vector& a) {
  return {middle_of(a.x), middle_of(a.y), middle_of(a.z)};
}

// Returns factor * a, in fewer operations. Requires factor.inf() >= 0: each end of the product is
// that end of a times the end of the factor that moves it outward.
inline rounded_interval scaled(const rounded_interval& factor, const rounded_interval& a) {
  const double low = -a.inf(), high = a.sup();
  return {-rounded_product(low >= 0 ? factor.sup() : factor.inf(), low),
          rounded_product(high >= 0 ? factor.sup() : factor.inf(), high)};
}
inline interval_vector scaled(const rounded_interval& factor, const interval_vector& a) {
  return {scaled(factor, a.x), scaled(factor, a.y), scaled(factor, a.z)};
}

inline interval_vector quotient(const interval_vector& a, const rounded_interval& b) {
  return {quotient(a.x, b), quotient(a.y, b), quotient(a.z, b)};
}

// Returns an enclosure of the squared length; narrower than the scalar product of the vector with
// itself.
inline rounded_interval squared_length(const interval_vector& a) {
  return squared(a.x) + squared(a.y) + squared(a.z);
}

// A point of projective space: (w x, w y, w z, w), w > 0.
template <class Number>
struct weighted {
  space_vector<Number> at;
  Number weight = 1;

  friend weighted operator+(const weighted& a, const weighted& b) {
    return {a.at + b.at, a.weight + b.weight};
  }
  friend weighted operator*(const Number& s, const weighted& a) { return {s * a.at, s * a.weight}; }
};

using weighted_point = weighted<rounded_interval>;
using exact_weighted_point = weighted<dyadic>;

// Returns (1 - share) a + share b: a step of de Casteljau's algorithm.
template <class Number>
weighted<Number> mixed(const weighted<Number>& a, const weighted<Number>& b, const Number& share) {
  return (Number(1) - share) * a + share * b;
}

}  // namespace asterism::internal
