// SPDX-License-Identifier: MIT
//
// Defines the border of a face in the chart of its patch: the four sides of the rectangle, or the
// curves of the loops that trim it. Works in doubles; the results are proposals.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/surface/surface_chart.hpp"
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

namespace asterism::internal {

// Border of a face. Sides are numbered from 0. Those of a rectangle: 0 along u at the least v, 1
// along v at the greatest u, 2 along u at the greatest v, 3 along v at the least u; each runs with
// its parameter. Curves of loops run around.
class face_border {
 public:
  // Makes the border. Patch and chart must outlive this object.
  face_border(const surface_patch& patch, const surface_chart& chart);

  bool is_trimmed() const { return !trims_.empty(); }
  std::size_t sides() const { return is_trimmed() ? trims_.size() : 4; }
  // Returns the next side, going around counter-clockwise, or around a hole clockwise.
  std::size_t next(std::size_t side) const {
    return is_trimmed() ? trims_[side].next : (side + 1) % 4;
  }
  bool runs_around(std::size_t side) const { return is_trimmed() || side < 2; }
  // Returns the corners at the start and the end of a side, by its parameter. Corner k is where
  // side k starts, going around.
  std::array<std::size_t, 2> ends_of(std::size_t side) const;

  point corner(std::size_t k) const;
  // Returns the point of the chart at a place, from 0 to 1, of a side. Moves points of a curve
  // beyond the patch to its rectangle.
  point at(std::size_t side, double place) const;
  // Return the trimming curve of a side, and the number of curves in its loop.
  const trim_curve& curve(std::size_t side) const { return *trims_[side].curve; }
  std::size_t curves_in_loop(std::size_t side) const;

 private:
  const surface_chart* chart_;
  std::vector<trim_link> trims_;
};

}  // namespace asterism::internal
