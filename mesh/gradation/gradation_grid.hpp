// SPDX-License-Identifier: MIT
//
// Chooses the points of a box at which a metric field is sampled, densely where cells are split,
// and interpolates between them.
//
// A quadtree of cells. Sides of cells that share an edge differ by a factor of two at most, so that
// an edge has at most one node between its ends; every cell is cut into triangles from its middle
// to the nodes on its edges. The triangles fit together, so what is interpolated linearly in them
// is continuous.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class gradation_grid {
 public:
  // Makes about square cells, 16 along the longer side of the box, which must have an extent.
  explicit gradation_grid(const bounding_box& box);

  static constexpr int deepest = 20;  // halvings below the 16 cells
  static constexpr std::uint32_t none = UINT32_MAX;

  struct cell {
    std::uint32_t x, y, side;       // in units of the smallest cell that is possible
    std::uint32_t children = none;  // the first of four
    std::array<std::uint32_t, 4> corners{none, none, none, none};  // counter-clockwise, lower left
    std::uint32_t middle = none;
    bool leaf() const { return children == none; }
  };

  const std::vector<cell>& cells() const { return cells_; }
  // Nodes in the order of their creation; they are never removed.
  std::size_t nodes() const { return positions_.size(); }
  const point& position(std::uint32_t node) const { return positions_[node]; }
  // Returns the displacement from the lower left to the upper right corner.
  point diagonal(const cell& c) const;

  // Splits leaf `c` in four, and larger neighbours as needed. Returns false at the deepest level.
  bool split(std::uint32_t c);

  // Lists the nodes on the boundary of a leaf, counter-clockwise from the lower left corner: 4
  // to 8.
  struct rim {
    std::array<std::uint32_t, 8> node;
    std::size_t size = 0;
  };
  rim rim_of(const cell& leaf) const;

  // Finds the triangle around a point (outside the box: around the nearest point of it), and the
  // weights of its nodes: not negative, with sum 1.
  struct place {
    std::array<std::uint32_t, 3> node;
    std::array<double, 3> weight;
  };
  place locate(const point& q) const;

 private:
  std::uint32_t node_at(std::uint32_t x, std::uint32_t y);
  std::uint32_t find_node(std::uint32_t x, std::uint32_t y) const;
  std::uint32_t add_cell(std::uint32_t x, std::uint32_t y, std::uint32_t side);
  std::uint32_t leaf_at(std::uint32_t x, std::uint32_t y) const;
  std::vector<std::uint32_t> larger_neighbours(const cell& c) const;

  point low_, high_;
  std::uint32_t columns_, rows_;
  std::vector<cell> cells_;
  std::vector<point> positions_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace asterism::internal
