// SPDX-License-Identifier: MIT
//
// Bounds how fast a graded field varies in parts of its triangles. Source: docs/math/guarantee.md,
// "The field's sigma".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/metric/graded_parts.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/metric/tensor_variation.hpp"

namespace asterism::internal {

class graded_region {
 public:
  // Intersection of a box with the triangle of this number.
  struct part {
    bounding_box box;
    std::size_t triangle = 0;
  };

  // The field must outlive this object.
  explicit graded_region(const graded_parts& field);

  std::vector<part> first_parts() const;
  // True only if no point of the box is in the triangle.
  bool misses_triangle(const part& p) const;
  // Returns the bounds; fails where nothing is known of the field as given.
  result<variation_of_part> bounds_of(const part& p) const;
  // Returns both halves, across the longer side; nothing where no double is between the ends of
  // that side.
  static std::optional<std::array<part, 2>> halves(const part& p);

 private:
  std::optional<tensor_jet> over(const part& p, const bounding_box& box) const;

  std::vector<graded_triangle> triangles_;
  const sized_field* given_;  // null where it is no formula
};

}  // namespace asterism::internal
