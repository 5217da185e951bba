// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

box_index::box_index(const bounding_box& box) {
  nodes_.emplace_back();
  node& root = nodes_[0];
  root.half = {box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2};
  root.middle = {box.low.x + root.half.x, box.low.y + root.half.y};
}

// Goes down while the child's cell is no smaller than the item. With `grow` missing children are
// made and the boxes on the way widened.
std::uint32_t box_index::place(const bounding_box& box, bool grow) {
  // Halved, as sums and differences of finite doubles may overflow.
  const point half_size{box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2};
  const point centre{box.low.x + half_size.x, box.low.y + half_size.y};
  std::uint32_t at = 0;
  for (int level = 0;; ++level) {
    if (grow) {
      node& n = nodes_[at];
      if (!n.used) n.around = box;
      n.used = true;
      n.around.include(box);
    }
    const point quarter{nodes_[at].half.x / 2, nodes_[at].half.y / 2};
    if (level >= most_levels || half_size.x > quarter.x || half_size.y > quarter.y) return at;
    if (nodes_[at].first_child == none) {
      if (!grow) return at;
      const auto first = static_cast<std::uint32_t>(nodes_.size());
      nodes_[at].first_child = first;
      const point middle = nodes_[at].middle;
      for (int child = 0; child < 4; ++child) {
        nodes_.emplace_back();
        nodes_.back().half = quarter;
        nodes_.back().middle = {middle.x + ((child & 1) != 0 ? quarter.x : -quarter.x),
                                middle.y + ((child & 2) != 0 ? quarter.y : -quarter.y)};
      }
    }
    const node& n = nodes_[at];
    at = n.first_child + (centre.x >= n.middle.x ? 1U : 0U) + (centre.y >= n.middle.y ? 2U : 0U);
  }
}

void box_index::insert(std::uint32_t item, const bounding_box& box) {
  nodes_[place(box, true)].items.push_back(item);
}

void box_index::remove(std::uint32_t item, const bounding_box& box) {
  std::vector<std::uint32_t>& items = nodes_[place(box, false)].items;
  items.erase(std::remove(items.begin(), items.end(), item), items.end());
}

}  // namespace asterism::internal
