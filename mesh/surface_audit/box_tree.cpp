// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

void space_box::include(const space_box& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], other.low[k]);
    high[k] = std::max(high[k], other.high[k]);
  }
}

void space_box::include(const space_point& p) { include(of(p)); }

double space_box::diagonal() const {
  return elementary::hypot(elementary::hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
}

box_tree::box_tree(const std::vector<space_box>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size()), 0});
  for (std::uint32_t at = 0; at < nodes_.size(); ++at) divide(at, boxes);
}

void box_tree::divide(std::uint32_t at, const std::vector<space_box>& boxes) {
  constexpr std::uint32_t most_of_a_leaf = 4;
  const std::uint32_t begin = nodes_[at].begin, end = nodes_[at].end;
  if (begin == end) return;
  space_box box = boxes[items_[begin]];
  for (std::uint32_t k = begin; k < end; ++k) box.include(boxes[items_[k]]);
  nodes_[at].box = box;
  if (end - begin <= most_of_a_leaf) return;
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (box.high[k] - box.low[k] > box.high[longest] - box.low[longest]) longest = k;
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const double at_a = boxes[a].low[longest] + boxes[a].high[longest];
    const double at_b = boxes[b].low[longest] + boxes[b].high[longest];
    return at_a != at_b ? at_a < at_b : a < b;
  };
  const auto start = items_.begin();
  std::nth_element(start + begin, start + middle, start + end, before);
  // Sorts both parts: the selection determines only which items each part has.
  std::sort(start + begin, start + middle);
  std::sort(start + middle, start + end);
  nodes_[at].first_child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, middle, 0});
  nodes_.push_back({{}, middle, end, 0});
}

}  // namespace asterism::internal
