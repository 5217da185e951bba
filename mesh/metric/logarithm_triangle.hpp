// SPDX-License-Identifier: MIT
//
// Bounds how fast a metric varies in a triangle in which its logarithm is linear, and halves it.
// Source: docs/math/guarantee.md, "The field's sigma". In a floating_point_scope(rounding::upward)
// where it says so.
#pragma once

#include <array>
#include <optional>

#include "asterism/core/rounded_interval.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/tensor_variation.hpp"

namespace asterism::internal {

// Encloses the entries of a logarithm, l11, l12 and l22.
using enclosed_logarithm = std::array<rounded_interval, 3>;

struct logarithm_triangle {
  // Lie near the corners of the part, off by at most 2^-52 of the greatest coordinate of the whole
  // triangle for each halving.
  std::array<point, 3> corners;
  double greatest_coordinate = 0;
  std::array<enclosed_logarithm, 3> logarithms;  // at the corners
  enclosed_logarithm by_x, by_y;                 // derivatives, those of the whole triangle
  int depth = 0;                                 // halvings so far

  // Makes it of the tensors at the corners; nothing where these are not counter-clockwise.
  static std::optional<logarithm_triangle> make(const site& a, const site& b, const site& c);

  // Returns the bounds of the part. Stands in such a scope.
  variation_of_part bounds() const;
  // Returns the parts on both sides of the middle of the edge along which the logarithm changes
  // most; nothing after 60 halvings.
  std::optional<std::array<logarithm_triangle, 2>> halves() const;
};

}  // namespace asterism::internal
