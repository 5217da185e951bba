// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/gradation_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal {

namespace {

constexpr std::uint32_t cells_along = 16;
constexpr std::uint32_t root_side = 1U << static_cast<unsigned>(gradation_grid::deepest);

std::uint64_t key(std::uint32_t x, std::uint32_t y) {
  return (static_cast<std::uint64_t>(x) << 32U) | y;
}

// Returns the number of cells along a side of length `side`, where the longer side has 16.
std::uint32_t cells_of(double side, double longer) {
  const double n = std::ceil(cells_along * (side / longer));
  return std::max(1U, static_cast<std::uint32_t>(n));
}

// Returns the point from `low` to `high` at t in [0, 1], without overflow and exact at the ends.
double between(double low, double high, double t) { return low * (1 - t) + high * t; }

// Returns the parameter of x from `low` to `high`, clamped to [0, 1].
double fraction(double low, double high, double x) {
  if (!(high > low)) return 0;
  return std::clamp((x / 2 - low / 2) / (high / 2 - low / 2), 0.0, 1.0);
}

}  // namespace

gradation_grid::gradation_grid(const bounding_box& box) : low_(box.low), high_(box.high) {
  const double width = high_.x / 2 - low_.x / 2, height = high_.y / 2 - low_.y / 2;
  const double longer = std::max(width, height);
  columns_ = cells_of(width, longer);
  rows_ = cells_of(height, longer);
  for (std::uint32_t j = 0; j < rows_; ++j)
    for (std::uint32_t i = 0; i < columns_; ++i) add_cell(i * root_side, j * root_side, root_side);
}

std::uint32_t gradation_grid::find_node(std::uint32_t x, std::uint32_t y) const {
  const auto found = numbers_.find(key(x, y));
  return found == numbers_.end() ? none : found->second;
}

std::uint32_t gradation_grid::node_at(std::uint32_t x, std::uint32_t y) {
  const auto number = static_cast<std::uint32_t>(positions_.size());
  const auto [entry, is_new] = numbers_.try_emplace(key(x, y), number);
  if (is_new) {
    const double s = static_cast<double>(x) / (static_cast<double>(columns_) * root_side);
    const double t = static_cast<double>(y) / (static_cast<double>(rows_) * root_side);
    positions_.push_back({between(low_.x, high_.x, s), between(low_.y, high_.y, t)});
  }
  return entry->second;
}

std::uint32_t gradation_grid::add_cell(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
  cell c{x, y, side};
  c.corners = {node_at(x, y), node_at(x + side, y), node_at(x + side, y + side),
               node_at(x, y + side)};
  c.middle = node_at(x + side / 2, y + side / 2);
  cells_.push_back(c);
  return static_cast<std::uint32_t>(cells_.size() - 1);
}

point gradation_grid::diagonal(const cell& c) const {
  const point &a = positions_[c.corners[0]], &b = positions_[c.corners[2]];
  return {b.x - a.x, b.y - a.y};
}

std::uint32_t gradation_grid::leaf_at(std::uint32_t x, std::uint32_t y) const {
  std::uint32_t at = (y / root_side) * columns_ + x / root_side;
  while (!cells_[at].leaf()) {
    const cell& c = cells_[at];
    const std::uint32_t half = c.side / 2;
    at = c.children + (x - c.x >= half ? 1U : 0U) + (y - c.y >= half ? 2U : 0U);
  }
  return at;
}

std::vector<std::uint32_t> gradation_grid::larger_neighbours(const cell& c) const {
  std::vector<std::uint32_t> found;
  const auto look = [&](bool inside, std::uint32_t x, std::uint32_t y) {
    if (!inside) return;
    const std::uint32_t other = leaf_at(x, y);
    if (cells_[other].side > c.side) found.push_back(other);
  };
  look(c.x > 0, c.x - 1, c.y);
  look(c.y > 0, c.x, c.y - 1);
  look(c.x + c.side < columns_ * root_side, c.x + c.side, c.y);
  look(c.y + c.side < rows_ * root_side, c.x, c.y + c.side);
  return found;
}

bool gradation_grid::split(std::uint32_t c) {
  // Returns false for cells of less than four units: their halves would have no middle in whole
  // units.
  if (cells_[c].side < 4) return false;
  // Splits larger neighbours first. Each of them is larger by a factor of two: the recursion ends
  // at the roots.
  for (const std::uint32_t other : larger_neighbours(cells_[c]))
    if (cells_[other].leaf() && !split(other)) return false;
  const cell whole = cells_[c];
  const std::uint32_t half = whole.side / 2;
  cells_[c].children = add_cell(whole.x, whole.y, half);
  add_cell(whole.x + half, whole.y, half);
  add_cell(whole.x, whole.y + half, half);
  add_cell(whole.x + half, whole.y + half, half);
  return true;
}

gradation_grid::rim gradation_grid::rim_of(const cell& leaf) const {
  const std::uint32_t half = leaf.side / 2, x = leaf.x + half, y = leaf.y + half;
  const std::array<std::uint32_t, 4> between_corners = {
      find_node(x, leaf.y), find_node(leaf.x + leaf.side, y), find_node(x, leaf.y + leaf.side),
      find_node(leaf.x, y)};
  rim found{};
  for (std::size_t i = 0; i < 4; ++i) {
    found.node[found.size++] = leaf.corners[i];
    if (between_corners[i] != none) found.node[found.size++] = between_corners[i];
  }
  return found;
}

gradation_grid::place gradation_grid::locate(const point& q) const {
  const double x = fraction(low_.x, high_.x, q.x) * columns_ * root_side;
  const double y = fraction(low_.y, high_.y, q.y) * rows_ * root_side;
  const auto unit = [](double t, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(t), count * root_side - 1);
  };
  const cell& c = cells_[leaf_at(unit(x, columns_), unit(y, rows_))];
  // Finds the place relative to the middle, in halves of the side: the edge that the ray through q
  // crosses, the share of the ray up to q, and the position on that edge, from 0 to 1
  // counter-clockwise.
  const double half = static_cast<double>(c.side) / 2;
  const double u = (x - c.x) / half - 1, v = (y - c.y) / half - 1;
  const bool upright = std::abs(u) > std::abs(v);
  const double far = std::clamp(upright ? std::abs(u) : std::abs(v), 0.0, 1.0);
  const std::size_t edge = upright ? (u > 0 ? 1U : 3U) : (v < 0 ? 0U : 2U);
  const double along = far > 0 ? (upright ? v : u) / far : 0;
  double t = std::clamp(((edge == 0 || edge == 1 ? along : -along) + 1) / 2, 0.0, 1.0);
  std::uint32_t from = c.corners[edge], to = c.corners[(edge + 1) % 4];
  const std::uint32_t h = c.side / 2;
  const std::uint32_t between_x = c.x + (edge == 1 ? c.side : edge == 3 ? 0 : h);
  const std::uint32_t between_y = c.y + (edge == 2 ? c.side : edge == 0 ? 0 : h);
  const std::uint32_t halfway = find_node(between_x, between_y);
  if (halfway != none) {
    (t < 0.5 ? to : from) = halfway;
    t = t < 0.5 ? 2 * t : 2 * t - 1;
  }
  return {{c.middle, from, to}, {1 - far, far * (1 - t), far * t}};
}

}  // namespace asterism::internal
