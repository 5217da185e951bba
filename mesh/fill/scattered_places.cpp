// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/scattered_places.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "asterism/core/random.hpp"

namespace asterism::internal {
namespace {

constexpr std::uint32_t deepest = 30;

// A cell of a quadtree; the sides are those of the box divided by 2^level.
struct quadtree_cell {
  std::uint32_t column, row, level;
};

// Returns a number in [-1/2, 1/2) that depends on the cell alone.
double shift_of(const quadtree_cell& c, std::uint64_t which) {
  return fraction_of(std::uint64_t{c.column} << 32U | c.row, std::uint64_t{2} * c.level + which) -
         0.5;
}

// Returns the displacement from a cell's middle to its upper right corner.
point half_of(const quadtree_cell& c, const bounding_box& box) {
  const double part = 1 / static_cast<double>(std::uint64_t{1} << c.level);
  return {part * (box.high.x - box.low.x) / 2, part * (box.high.y - box.low.y) / 2};
}

point place_in(const quadtree_cell& c, const bounding_box& box) {
  const point half = half_of(c, box);
  return {box.low.x + (2 * c.column + 1 + shift_of(c, 0)) * half.x,
          box.low.y + (2 * c.row + 1 + shift_of(c, 1)) * half.y};
}

}  // namespace

void visit_scattered(
    const bounding_box& box, std::size_t most,
    const std::function<bool(const point& place, const point& half)>& visit,
    const std::function<void(const std::function<std::vector<point>()>& next)>& announce) {
  if (!(box.high.x - box.low.x > 0 && box.high.y - box.low.y > 0)) return;
  std::vector<quadtree_cell> cells{{0, 0, 0}};
  std::size_t announced = 0;
  for (std::size_t i = 0; i < cells.size() && i < most; ++i) {
    if (announce && i == announced) {
      announced = std::min(cells.size(), most);
      announce([&] {
        std::vector<point> next;
        for (std::size_t k = i; k < announced; ++k) next.push_back(place_in(cells[k], box));
        return next;
      });
    }
    const quadtree_cell c = cells[i];
    if (!visit(place_in(c, box), half_of(c, box)) || c.level == deepest) continue;
    for (const std::uint32_t quarter : {0U, 1U, 2U, 3U})
      cells.push_back({2 * c.column + quarter % 2, 2 * c.row + quarter / 2, c.level + 1});
  }
}

}  // namespace asterism::internal
