// SPDX-License-Identifier: MIT
//
// Computes with displacements and their lengths in a metric tensor, over any number type.
#pragma once

#include "asterism/core/interval.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

template <class Number>
struct displacement {
  Number x, y;

  friend displacement operator-(const displacement& a, const displacement& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend displacement operator+(const displacement& a, const displacement& b) {
    return {a.x + b.x, a.y + b.y};
  }
  displacement operator-() const { return {-x, -y}; }
};

template <class Number>
displacement<Number> operator*(const Number& factor, const displacement<Number>& u) {
  return {factor * u.x, factor * u.y};
}

// Returns b - a.
template <class Number>
displacement<Number> between(const basic_point<Number>& a, const basic_point<Number>& b) {
  return {b.x - a.x, b.y - a.y};
}

// Squares a number. For an interval that straddles zero the lower end is not zero.
inline interval square(const interval& x) { return squared(x); }
template <class Number>
Number square(const Number& x) {
  return x * x;
}

// Returns M u.
template <class Number>
displacement<Number> apply(const basic_metric_tensor<Number>& m, const displacement<Number>& u) {
  return {m.m11 * u.x + m.m12 * u.y, m.m12 * u.x + m.m22 * u.y};
}

template <class Number>
Number dot(const displacement<Number>& u, const displacement<Number>& w) {
  return u.x * w.x + u.y * w.y;
}

template <class Number>
Number cross(const displacement<Number>& u, const displacement<Number>& w) {
  return u.x * w.y - u.y * w.x;
}

// Returns u^T M u.
template <class Number>
Number squared_length(const basic_metric_tensor<Number>& m, const displacement<Number>& u) {
  const Number mixed = m.m12 * (u.x * u.y);
  return m.m11 * square(u.x) + m.m22 * square(u.y) + (mixed + mixed);
}

template <class Number>
basic_metric_tensor<Number> operator-(const basic_metric_tensor<Number>& a,
                                      const basic_metric_tensor<Number>& b) {
  return {a.m11 - b.m11, a.m12 - b.m12, a.m22 - b.m22};
}

// Converts points and sites to another number type; exact for every type that holds the doubles.
template <class Number>
basic_point<Number> convert(const point& p) {
  return {Number(p.x), Number(p.y)};
}
template <class Number>
basic_site<Number> convert(const site& s) {
  return {convert<Number>(s.position),
          {Number(s.metric.m11), Number(s.metric.m12), Number(s.metric.m22)}};
}

}  // namespace asterism::internal
