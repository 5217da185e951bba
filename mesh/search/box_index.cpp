// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/box_index.hpp"

#include <bit>

namespace asterism::internal {

box_index::box_index(const bounding_box& box) {
  nodes_.emplace_back();
  node& root = nodes_[0];
  root.half = {box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2};
  root.middle = {box.low.x + root.half.x, box.low.y + root.half.y};
}

// Makes the children of a node.
void box_index::divide(std::uint32_t at, division how) {
  nodes_[at].first_child[static_cast<std::size_t>(how)] = static_cast<std::uint32_t>(nodes_.size());
  const point middle = nodes_[at].middle;
  point half = nodes_[at].half;
  if (how != division::along_y) half.x /= 2;
  if (how != division::along_x) half.y /= 2;
  for (std::uint32_t child = 0; child < children(how); ++child) {
    const std::uint32_t upper = how == division::in_four ? 2 : 1;
    node& made = nodes_.emplace_back();
    made.half = half;
    made.middle = middle;
    if (how != division::along_y) made.middle.x += (child & 1U) != 0 ? half.x : -half.x;
    if (how != division::along_x) made.middle.y += (child & upper) != 0 ? half.y : -half.y;
  }
}

// Returns the way of division whose cells are no smaller than the box, if there is one.
std::optional<box_index::division> box_index::way_to_divide(std::uint32_t at,
                                                            const bounding_box& box) const {
  // Halves coordinates, as sums and differences of finite doubles may overflow.
  const bool is_narrow = box.high.x / 2 - box.low.x / 2 <= nodes_[at].half.x / 2,
             is_low = box.high.y / 2 - box.low.y / 2 <= nodes_[at].half.y / 2;
  if (is_narrow && is_low) return division::in_four;
  if (is_narrow) return division::along_x;
  if (is_low) return division::along_y;
  return std::nullopt;
}

// Returns the child that holds the middle of the box.
std::uint32_t box_index::child_for(std::uint32_t at, division how, const bounding_box& box) const {
  const node& n = nodes_[at];
  const double x = box.low.x + (box.high.x / 2 - box.low.x / 2),
               y = box.low.y + (box.high.y / 2 - box.low.y / 2);
  const std::uint32_t right = x >= n.middle.x ? 1 : 0, above = y >= n.middle.y ? 1 : 0;
  const std::uint32_t first = n.first_child[static_cast<std::size_t>(how)];
  if (how == division::in_four) return first + right + 2 * above;
  return first + (how == division::along_x ? right : above);
}

// Descends while the child's cell is no smaller than the item. With `grow`, makes missing children
// of quartered cells and widens the boxes on the way.
std::uint32_t box_index::place(const bounding_box& box, bool grow) {
  std::uint32_t at = 0;
  for (int level = 0;; ++level) {
    if (grow) {
      node& n = nodes_[at];
      if (!n.used) n.around = box;
      n.used = true;
      n.around.include(box);
    }
    const auto how = way_to_divide(at, box);
    if (level >= most_levels || !how) return at;
    if (nodes_[at].first_child[static_cast<std::size_t>(*how)] == none) {
      if (!grow || *how != division::in_four) return at;
      divide(at, *how);
    }
    at = child_for(at, *how, box);
  }
}

// Halves a cell along each axis along which many of its items are small, and moves these items to
// the halves. Does so when the number of items has doubled, so that an insertion takes constant
// time on average.
void box_index::relieve(std::uint32_t at) {
  constexpr std::size_t many = 16;
  if (nodes_[at].items.size() < 2 * many || !std::has_single_bit(nodes_[at].items.size())) return;
  for (const division how : {division::along_x, division::along_y}) {
    if (nodes_[at].first_child[static_cast<std::size_t>(how)] != none) continue;
    const auto stays = [&](const item_box& i) { return way_to_divide(at, i.box) != how; };
    std::vector<item_box>& items = nodes_[at].items;
    const auto first = std::stable_partition(items.begin(), items.end(), stays);
    if (static_cast<std::size_t>(items.end() - first) <= many) continue;
    const std::vector<item_box> moved(first, items.end());
    items.erase(first, items.end());
    divide(at, how);
    for (const item_box& i : moved) nodes_[place(i.box, true)].items.push_back(i);
  }
}

void box_index::insert(std::uint32_t item, const bounding_box& box) {
  const std::uint32_t at = place(box, true);
  nodes_[at].items.push_back({item, box});
  relieve(at);
}

void box_index::remove(std::uint32_t item, const bounding_box& box) {
  std::vector<item_box>& items = nodes_[place(box, false)].items;
  std::erase_if(items, [item](const item_box& i) { return i.item == item; });
}

}  // namespace asterism::internal
