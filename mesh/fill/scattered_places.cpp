// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/scattered_places.hpp"

#include <cstdint>
#include <vector>

namespace asterism::internal {
namespace {

constexpr std::uint32_t deepest = 30;

// Sides are the box's divided by 2^level.
struct quadtree_cell {
  std::uint32_t column, row, level;
};

// In [-1/2, 1/2); depends on all bits (the mixing is splitmix64's).
double shift_of(const quadtree_cell& c, std::uint64_t which) {
  std::uint64_t z = (std::uint64_t{c.column} << 32U | c.row) * 0x9e3779b97f4a7c15U +
                    (std::uint64_t{2} * c.level + which) * 0xd1342543de82ef95U + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53 - 0.5;
}

}  // namespace

void visit_scattered(const bounding_box& box, std::size_t most,
                     const std::function<bool(const point& place, const point& half)>& visit) {
  const point whole{box.high.x - box.low.x, box.high.y - box.low.y};
  if (!(whole.x > 0 && whole.y > 0)) return;
  std::vector<quadtree_cell> cells{{0, 0, 0}};
  for (std::size_t i = 0; i < cells.size() && i < most; ++i) {
    const quadtree_cell c = cells[i];
    const double part = 1 / static_cast<double>(std::uint64_t{1} << c.level);
    const point half{part * whole.x / 2, part * whole.y / 2};
    const point place{box.low.x + (2 * c.column + 1 + shift_of(c, 0)) * half.x,
                      box.low.y + (2 * c.row + 1 + shift_of(c, 1)) * half.y};
    if (!visit(place, half) || c.level == deepest) continue;
    for (const std::uint32_t quarter : {0U, 1U, 2U, 3U})
      cells.push_back({2 * c.column + quarter % 2, 2 * c.row + quarter / 2, c.level + 1});
  }
}

}  // namespace asterism::internal
