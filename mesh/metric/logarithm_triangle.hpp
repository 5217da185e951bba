// SPDX-License-Identifier: MIT
//
// Bounds how fast a metric varies in a triangle in which its logarithm is linear, and halves it.
// Source: docs/math/guarantee.md, "The field's sigma". Some functions require a
// floating_point_scope(rounding::upward), as stated there.
#pragma once

#include <array>
#include <optional>

#include "asterism/core/rounded_interval.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/tensor_variation.hpp"

namespace asterism::internal {

// Enclosures of a logarithm's entries l11, l12 and l22.
using enclosed_logarithm = std::array<rounded_interval, 3>;

// Returns the tensor whose logarithm has these entries over a part, with its derivatives. Requires
// a floating_point_scope(rounding::upward).
tensor_jet exponential_over(const enclosed_logarithm& l, const enclosed_logarithm& by_x,
                            const enclosed_logarithm& by_y);

struct logarithm_triangle {
  // Computed corners of the part, with errors of at most 2^-52 of the greatest coordinate of the
  // whole triangle for each halving.
  std::array<point, 3> corners;
  double greatest_coordinate = 0;
  std::array<enclosed_logarithm, 3> logarithms;  // at the corners
  enclosed_logarithm by_x, by_y;                 // derivatives, those of the whole triangle
  int depth = 0;                                 // halvings so far

  // Makes the triangle from the tensors at its corners; nothing where these are not
  // counter-clockwise.
  static std::optional<logarithm_triangle> make(const site& a, const site& b, const site& c);

  // Returns the bounds of the part. Requires a floating_point_scope(rounding::upward).
  variation_of_part bounds() const;
  // Returns the halves of the part, cut at the middle of the edge along which the logarithm changes
  // most; nothing after 60 halvings.
  std::optional<std::array<logarithm_triangle, 2>> halves() const;
};

}  // namespace asterism::internal
