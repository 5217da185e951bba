// SPDX-License-Identifier: MIT
//
// Defines points, metric tensors and sites as plain values over any number type.
//
// Units: coordinates are in the units of the domain; a metric tensor maps a displacement u to the
// squared length u^T M u, so an edge as long as wanted has length 1.
// Ranges: every finite double is allowed; metric tensors are symmetric by construction (m12 is
// stored once). Positive definiteness is a predicate (predicates/positive_definite.hpp), not an
// invariant of the type: what reads input checks it.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace asterism {

// A point of the plane.
template <class Number>
struct basic_point {
  Number x{}, y{};
  friend bool operator==(const basic_point&, const basic_point&) = default;
};

// A symmetric 2x2 tensor [m11 m12; m12 m22].
template <class Number>
struct basic_metric_tensor {
  Number m11{}, m12{}, m22{};
  friend bool operator==(const basic_metric_tensor&, const basic_metric_tensor&) = default;
};

// A point with its own metric, by which it measures lengths and angles everywhere.
template <class Number>
struct basic_site {
  basic_point<Number> position;
  basic_metric_tensor<Number> metric;
  friend bool operator==(const basic_site&, const basic_site&) = default;
};

// A point in doubles, as in input and output.
using point = basic_point<double>;
// A metric tensor in doubles, as in input and output.
using metric_tensor = basic_metric_tensor<double>;
// A site in doubles, as in input and output.
using site = basic_site<double>;

// True if the tensors are equal bit for bit, whatever the floating-point environment: if the
// processor is set to flush, == takes subnormal numbers for zeros. False for 0 and -0.
constexpr bool identical(const metric_tensor& a, const metric_tensor& b) {
  using bits = std::array<std::uint64_t, 3>;
  return std::bit_cast<bits>(a) == std::bit_cast<bits>(b);
}

// True if a comes before b in the order used to break ties: by geometry, so it is the same in every
// star.
constexpr bool lexicographically_less(const point& a, const point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace asterism
