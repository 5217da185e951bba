// SPDX-License-Identifier: MIT
//
// Finds boxes by their place: a loose quadtree for the subsegments of the boundary, which are
// replaced by smaller ones as the boundary is split.
//
// An item lies in the node that holds its middle, on the level whose cells are about as large as
// the item: long subsegments stay near the root, short ones go deep, and a small question never has
// to look through long lists. A node knows a box around everything that ever was below it.
// Deterministic: items are visited in an order that depends on the changes alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class box_index {
 public:
  box_index() = default;
  // Makes an empty index for items in, or not far outside, the box.
  explicit box_index(const bounding_box& box);

  void insert(std::uint32_t item, const bounding_box& box);
  // Removes an item. Requires that it was inserted with this box.
  void remove(std::uint32_t item, const bounding_box& box);

  // Calls visit(item) for every item whose box meets the closed one, and perhaps for some others.
  // visit returns whether to go on; so does this.
  template <class Visit>
  bool visit(const bounding_box& box, Visit&& visit) const;

 private:
  static constexpr int most_levels = 40;
  static constexpr std::uint32_t none = 0;

  struct node {
    bounding_box around;
    point middle, half;
    std::uint32_t first_child = none;
    bool used = false;  // `around` means something
    std::vector<std::uint32_t> items;
  };

  std::uint32_t place(const bounding_box& box, bool grow);

  std::vector<node> nodes_;  // the root first
};

inline bool boxes_meet(const bounding_box& a, const bounding_box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

inline bounding_box box_of(const point& p, const point& q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
}

template <class Visit>
bool box_index::visit(const bounding_box& box, Visit&& visit) const {
  std::array<std::uint32_t, 3 * most_levels + 4> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const node& n = nodes_[open[--waiting]];
    if (!n.used || !boxes_meet(n.around, box)) continue;
    for (const std::uint32_t item : n.items)
      if (!visit(item)) return false;
    if (n.first_child != none)
      for (std::uint32_t i = 0; i < 4; ++i) open[waiting++] = n.first_child + i;
  }
  return true;
}

}  // namespace asterism::internal
