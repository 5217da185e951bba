// SPDX-License-Identifier: MIT
//
// Finds boxes in space near a point: a binary tree of boxes over items in the order given.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

struct space_box {
  std::array<double, 3> low{}, high{};

  void include(const space_box& other);
  void include(const space_point& p);
  static space_box of(const space_point& p) { return {{p.x, p.y, p.z}, {p.x, p.y, p.z}}; }
  double diagonal() const;
};

// Returns the squared distance of p from the box, rounded in the present rounding mode. Upward, it
// is at least the true one, but for the rounding of three differences.
inline double squared_distance(const space_box& box, const plain_vector& p) {
  const std::array<double, 3> at = {p.x, p.y, p.z};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double out = std::max({box.low[k] - at[k], at[k] - box.high[k], 0.0});
    sum += out * out;
  }
  return sum;
}

class box_tree {
 public:
  // Halves the items at the median of their middles along the longest side of the box; equal
  // middles are ordered by number.
  explicit box_tree(const std::vector<space_box>& boxes);

  // Calls visit(item) for the items of leaves whose box is within the squared distance `limit()` of
  // p.
  template <class Limit, class Visit>
  void visit_near(const plain_vector& p, const Limit& limit, const Visit& visit) const {
    std::array<std::uint32_t, 128> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const node& n = nodes_[stack[--depth]];
      if (squared_distance(n.box, p) > limit()) continue;
      if (n.first_child == 0) {
        for (std::uint32_t k = n.begin; k < n.end; ++k) visit(items_[k]);
        continue;
      }
      const std::uint32_t left = n.first_child, right = left + 1;
      const bool left_first =
          squared_distance(nodes_[left].box, p) <= squared_distance(nodes_[right].box, p);
      stack[depth++] = left_first ? right : left;
      stack[depth++] = left_first ? left : right;
    }
  }

 private:
  struct node {
    space_box box;
    std::uint32_t begin = 0, end = 0, first_child = 0;  // 0: a leaf
  };
  void divide(std::uint32_t at, const std::vector<space_box>& boxes);

  std::vector<std::uint32_t> items_;
  std::vector<node> nodes_;
};

}  // namespace asterism::internal
