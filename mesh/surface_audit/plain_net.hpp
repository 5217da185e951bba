// SPDX-License-Identifier: MIT
//
// Writes a piece over a triangle of its parameters in Bernstein form in doubles, with a bound of
// its difference from the exact net: the fast way of triangle_net.hpp, whose intervals take some
// twenty times as long.
//
// A net's point is sum b_i P_i with shares b_i >= 0, sum 1, as long as the corners are in the
// piece. A computed share is a product of sums of numbers that are not negative; each rounding to
// nearest changes it by a factor between 1 - 2^-53 and 1 + 2^-53. If each summand passes k
// roundings, the sum is off by at most ((1 + 2^-53)^k - 1) sum b_i |P_i|. If |P_i| <= X w_i with
// weights w_i > 0 of the control points, that is at most the same factor times X w, with w the
// net's own weight: the error is no greater relative to the weight than that of the greatest
// control point, however the weights differ.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Coordinates x, y, z (times the weight) and the weight of each point. The true coordinates differ
// from these by at most `off`, the true weights by at most `weight_off`, both times the computed
// weight.
struct plain_triangle_net {
  int degree = 0;
  std::vector<std::array<double, 4>> points;
  double off = 0, weight_off = 0;
};

// Returns the largest number of roundings in a summand, for degrees p and q:
//   3 p and 3 q in the shares of the two directions: 1 - s, its product, the sum, p times;
//   1 + p and 1 + q for products with control points and their sums;
//   1 for the number of ways, net_size(min(p, q)) for sums of pairs of one multi-index;
//   2 for the inverse of the number of all ways, and the product with it.
constexpr int roundings_of_net(int p, int q) {
  return 4 * (p + q) + static_cast<int>(net_size(p < q ? p : q)) + 5;
}

// Returns the net in doubles; none where a corner may be outside of the piece, a weight may not be
// positive, or corners or weights are known with so large an error that intervals are narrower.
// Works in any rounding mode: it sets its own, and has the same bits on every machine.
std::optional<plain_triangle_net> plain_net_over(const tensor_net& from,
                                                 const parameter_triangle& corners,
                                                 bool is_rational);

}  // namespace asterism::internal
