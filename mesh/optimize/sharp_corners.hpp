// SPDX-License-Identifier: MIT
//
// Finds the corners of the domain that are below the angle bound as their own metric measures them:
// no triangulation mends those. In plain doubles.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/optimize/mutable_triangulation.hpp"

namespace asterism::internal::fitting {

class sharp_corners {
 public:
  // Finds the corners below the bound, which is in degrees.
  sharp_corners(const mutable_triangulation& net, double angle_bound);

  // True if a triangle of these vertices, counter-clockwise, lies in such a corner.
  bool touch(const mutable_triangulation& net, const std::array<vertex_index, 3>& v) const;

 private:
  // Corner swept counter-clockwise from one direction to the other.
  struct corner {
    vertex_index vertex = 0;
    point first, last;
  };

  static std::optional<corner> corner_from(const mutable_triangulation& net, vertex_index t,
                                           std::size_t at, double angle_bound);

  std::vector<corner> corners_;  // by vertex
};

}  // namespace asterism::internal::fitting
