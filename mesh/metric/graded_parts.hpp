// SPDX-License-Identifier: MIT
//
// Lists the triangles in which a graded field is made of the field as given and of logarithms at
// the corners, for bounds of how fast it varies.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal {

// Holds a triangle, counter-clockwise. The logarithm of the metric in it is the mean, by the
// weights of a point among the corners, of the logarithms there; at kept corners, of that of the
// field as given at the point itself. Where all are kept the metric is the field as given.
struct graded_triangle {
  std::array<point, 3> corners;
  std::array<tensor_logarithm, 3> logarithms;
  std::array<bool, 3> kept;
};

class graded_parts {
 public:
  virtual ~graded_parts() = default;
  virtual std::vector<graded_triangle> triangles() const = 0;
  virtual const metric_field& given() const = 0;
};

}  // namespace asterism::internal
