// SPDX-License-Identifier: MIT
//
// Cuts the patches of a surface at their knots into Bezier pieces, whose control points are known
// as intervals, and refuses invalid surfaces by name. If a patch is already a Bezier patch, its
// control points are the given doubles, and only their products with the weights are enclosures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

// Largest degree in each direction: a net over a triangle has (p + q + 1)(p + q + 2) / 2 points,
// and products of binomials up to C(24, 12) are exact doubles.
inline constexpr int most_degree = 12;

// A Bezier piece over [u_low, u_high] x [v_low, v_high] of its patch. Its own parameters, s and t,
// run from 0 to 1.
struct bezier_piece {
  std::uint32_t patch = 0;
  int degree_u = 0, degree_v = 0;
  bool is_rational = false;  // else every weight is 1
  double u_low = 0, u_high = 1, v_low = 0, v_high = 1;
  // For the sides s = 0, s = 1, t = 0, t = 1 of the piece: whether the side is on a side of the
  // patch whose control points are all one point; and that point.
  std::array<bool, 4> is_point{};
  std::array<space_point, 4> point{};
  std::vector<weighted_point> net;               // rows of constant i, (degree_u + 1)(degree_v + 1)
  std::vector<std::array<double, 4>> plain_net;  // middles of them, for proposals

  std::size_t row() const { return static_cast<std::size_t>(degree_v) + 1; }
};

// Returns the pieces, patch by patch, in each in order of u, then v. Fails, naming the patch, for a
// degree of 0 or above most_degree; too few control points or knots; knots that descend, or whose
// first or last are not repeated degree + 1 times, or an inner one more than degree times; a number
// that is not finite, or beyond 2^300 or, other than 0, below 2^-300 in modulus, where products
// would leave the range of doubles; a weight that is zero or negative; a patch all of whose control
// points are one point.
result<std::vector<bezier_piece>> bezier_pieces(const surface& s);

// A point of a piece with its first derivatives by s and t, in doubles.
struct plain_jet {
  plain_vector at, by_s, by_t;
};
plain_jet evaluate(const bezier_piece& piece, double s, double t);

// A point of a piece with first and second derivatives, for metrics.
struct plain_second_jet {
  plain_jet first;
  plain_vector by_ss, by_st, by_tt;
};
plain_second_jet evaluate_twice(const bezier_piece& piece, double s, double t);

}  // namespace asterism::internal
