// SPDX-License-Identifier: MIT
//
// Finds boxes by their place: a loose quadtree for the subsegments of the boundary, which are
// replaced by smaller ones as the boundary is split.
//
// An item lies in the node that holds its middle, on the level whose cells are about as large as
// the item: long subsegments stay near the root, short ones go deep, and a query of a small box
// never goes through long lists. Cells are quartered while the item is small along both axes. A
// cell with many items that are small along one axis alone is halved along it: where metrics are
// thin, thousands of boxes are as high as the domain and thousands of times as narrow. A node knows
// a box around everything that ever was below it. Deterministic: items are visited in an order that
// depends on the changes alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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

  // Calls visit(item) for every item whose box meets the closed one, until visit returns false.
  // Returns whether it never did.
  template <class Visit>
  bool visit(const bounding_box& box, Visit&& visit) const;

 private:
  static constexpr int most_levels = 40;
  static constexpr std::uint32_t none = 0;

  // Division of a cell: into quarters, or into halves along one axis.
  enum class division : std::size_t { in_four, along_x, along_y };
  static constexpr std::size_t division_count = 3;

  struct item_box {
    std::uint32_t item;
    bounding_box box;
  };

  struct node {
    bounding_box around;
    point middle, half;
    // Index of the first of the four or two children, for each kind of division.
    std::array<std::uint32_t, division_count> first_child{none, none, none};
    bool used = false;  // `around` means something
    std::vector<item_box> items;
  };

  std::uint32_t place(const bounding_box& box, bool grow);
  std::optional<division> way_to_divide(std::uint32_t at, const bounding_box& box) const;
  std::uint32_t child_for(std::uint32_t at, division how, const bounding_box& box) const;
  void divide(std::uint32_t at, division how);
  void relieve(std::uint32_t at);
  static std::uint32_t children(division how) { return how == division::in_four ? 4 : 2; }

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
  // Size of the stack of a descent: each level leaves at most seven other children waiting.
  std::array<std::uint32_t, 7 * most_levels + 8> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const node& n = nodes_[open[--waiting]];
    if (!n.used || !boxes_meet(n.around, box)) continue;
    for (const item_box& i : n.items)
      if (boxes_meet(i.box, box) && !visit(i.item)) return false;
    for (const division how : {division::in_four, division::along_x, division::along_y}) {
      const std::uint32_t first = n.first_child[static_cast<std::size_t>(how)];
      if (first == none) continue;
      for (std::uint32_t i = 0; i < children(how); ++i) open[waiting++] = first + i;
    }
  }
  return true;
}

}  // namespace asterism::internal
