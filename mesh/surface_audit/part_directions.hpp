// SPDX-License-Identifier: MIT
//
// Bounds the derivatives of the surface over a part of a triangle, by ranges of their products with
// the triangle's longest edge, its normal, and the vector across both.
#pragma once

#include <optional>

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Holds a corner of a triangle, its longest edge e, its normal n = E1 x E2, and m = n x e.
struct triangle_frame {
  interval_vector corner, edge, across, normal;
  rounded_interval squared_edge, squared_normal;
};

// Holds ranges of p = e.q, r = m.q and c = n.q for vectors q of a field over a part.
struct direction_range {
  rounded_interval p, r, c;

  friend direction_range operator-(const direction_range& x, const direction_range& y) {
    return {x.p - y.p, x.r - y.r, x.c - y.c};
  }
  friend direction_range operator*(const rounded_interval& s, const direction_range& x) {
    return {s * x.p, s * x.r, s * x.c};
  }
};

// Holds two vector fields over a part whose cross product is r_u x r_v times a positive factor, or
// times a negative one.
struct two_directions {
  direction_range first, second;
  bool negative = false;
};

// Returns the derivatives along two of the part's own sides, times w / n, with w the weight and n
// the net's degree: differences of the net and, for a quotient r, these minus r times the
// differences of w. None where numbers leave the range of doubles, or a weight may not be positive.
// Requires a floating_point_scope(rounding::upward).
std::optional<two_directions> along_sides(const triangle_frame& frame, const triangle_net& net,
                                          bool is_rational);

}  // namespace asterism::internal
