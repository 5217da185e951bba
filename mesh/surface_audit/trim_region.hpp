// SPDX-License-Identifier: MIT
//
// Decides which part of the plane of the parameters belongs to a trimmed patch: the area that
// polygons with the region on their left enclose. Answers by exact comparisons and intervals, or
// "undecided".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asterism::internal {

using parameter_point = std::array<double, 2>;  // u and v

struct parameter_box {
  parameter_point low{}, high{};
};

struct parameter_segment {
  parameter_point from{}, to{};
};

enum class region_side { inside, outside, undecided };

class trim_region {
 public:
  // Takes closed polygons. Without any, all is inside.
  explicit trim_region(std::vector<parameter_segment> border);

  // Returns the side that all of a box is on, undecided where a segment may meet it. Requires a
  // floating_point_scope(rounding::upward).
  region_side side_of(const parameter_box& box) const;
  bool is_whole() const { return border_.empty(); }

 private:
  std::size_t row_of(double v) const;
  region_side side_of_point(const parameter_point& p) const;

  std::vector<parameter_segment> border_;
  double low_ = 0, height_ = 1;                   // of the rows
  std::vector<std::vector<std::uint32_t>> rows_;  // segments that reach into strips of v
};

// True if p is certainly in the triangle or on its sides, for either orientation. Requires a
// floating_point_scope(rounding::upward).
bool is_within(const std::array<parameter_point, 3>& triangle, const parameter_point& p);

}  // namespace asterism::internal
