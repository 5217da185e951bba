// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/hilbert_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr int levels = bits_of_place_on_curve / 2;

// Returns the cell of x in [low, high] cut into 2^levels.
std::uint32_t cell(double x, double low, double high) {
  const double part = (x / 2 - low / 2) / (high / 2 - low / 2);  // halved: no overflow
  constexpr double cells = 1U << levels;
  return static_cast<std::uint32_t>(std::clamp(part * cells, 0.0, cells - 1));
}

// Quarter of a cell that holds a point: its number on the curve, and the way in which the curve
// enters it. A way has x and y exchanged (1), both reversed (2), or both changes; tables have a row
// for each way of entering the cell.
struct quarter {
  std::uint32_t number, way;
};
using quarters = std::array<std::array<quarter, 4>, 4>;  // by the way, and by 2 right + upper

constexpr quarters quarters_of_curve() {
  quarters all{};
  for (std::uint32_t way = 0; way < 4; ++way)
    for (std::uint32_t at = 0; at < 4; ++at) {
      const bool exchanged = (way & 1U) != 0, turned = (way & 2U) != 0;
      const bool is_right = (at & 2U) != 0, is_upper = (at & 1U) != 0;
      const bool right = (exchanged ? is_upper : is_right) != turned,
                 upper = (exchanged ? is_right : is_upper) != turned;
      all[way][at] = upper   ? quarter{right ? 2U : 1U, way}
                     : right ? quarter{3U, way ^ 3U}
                             : quarter{0U, way ^ 1U};
    }
  return all;
}

// One of the 16 by 16 parts of a cell, four levels below it: its number along the curve, and the
// way in which the curve enters it.
struct curve_part {
  std::uint8_t number, way;
};
constexpr int levels_of_part = 4;
constexpr std::size_t parts_across = 1U << levels_of_part;
// Table of parts, indexed by the way of entering the cell and by 16 x + y.
using curve_parts = std::array<std::array<curve_part, parts_across * parts_across>, 4>;

constexpr curve_parts parts_of_curve() {
  constexpr quarters all = quarters_of_curve();
  curve_parts made{};
  for (std::uint32_t way = 0; way < 4; ++way)
    for (std::uint32_t x = 0; x < parts_across; ++x)
      for (std::uint32_t y = 0; y < parts_across; ++y) {
        quarter at{0, way};
        for (int level = levels_of_part - 1; level >= 0; --level) {
          const quarter& next = all[at.way][(x >> level & 1U) << 1 | (y >> level & 1U)];
          at = {at.number << 2 | next.number, next.way};
        }
        made[way][x * parts_across + y] = {static_cast<std::uint8_t>(at.number),
                                           static_cast<std::uint8_t>(at.way)};
      }
  return made;
}

// Each level picks one of four quarters; the curve enters and leaves it turned or mirrored. A table
// gives four levels at a time: branches would be mispredicted, and each reading of the table waits
// for the one before.
std::uint64_t place_on_curve(std::uint32_t x, std::uint32_t y) {
  static_assert(levels % levels_of_part == 0);
  static constexpr curve_parts all = parts_of_curve();
  constexpr std::uint32_t last = parts_across - 1;
  std::uint64_t place = 0;
  std::uint32_t way = 0;
  for (int level = levels - levels_of_part; level >= 0; level -= levels_of_part) {
    const curve_part& next = all[way][(x >> level & last) * parts_across + (y >> level & last)];
    place = place << (2 * levels_of_part) | next.number;
    way = next.way;
  }
  return place;
}

// Sorts the numbers of some points into the order of the curve; points of one cell keep their
// order.
template <class PointOf>
void sort_numbers(std::vector<std::uint32_t>& which, const PointOf& of, const bounding_box& box) {
  constexpr std::size_t chunk = 1024;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places(which.size());
  parallel_chunks(which.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      places[i] = {internal::place_on_curve(of(which[i]), box), static_cast<std::uint32_t>(i)};
  });
  parallel_sort(places.begin(), places.end());
  for (auto& [place, i] : places) i = which[i];
  for (std::size_t i = 0; i < which.size(); ++i) which[i] = places[i].second;
}

std::vector<std::uint32_t> all_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
  return numbers;
}

}  // namespace

std::uint64_t place_on_curve(const point& q, const bounding_box& box) {
  return place_on_curve(cell(q.x, box.low.x, box.high.x), cell(q.y, box.low.y, box.high.y));
}

void sort_along_curve(std::vector<std::uint32_t>& which, const std::vector<site>& sites,
                      const bounding_box& box) {
  sort_numbers(
      which, [&](std::uint32_t v) { return sites[v].position; }, box);
}

void sort_along_curve(std::vector<std::uint32_t>& which, const std::vector<point>& points,
                      const bounding_box& box) {
  sort_numbers(
      which, [&](std::uint32_t v) { return points[v]; }, box);
}

void sort_along_curve(std::span<point> points, const bounding_box& box) {
  const std::vector<point> unsorted(points.begin(), points.end());
  std::vector<std::uint32_t> order = all_numbers(points.size());
  sort_along_curve(order, unsorted, box);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = unsorted[order[i]];
}

std::vector<std::uint32_t> order_along_curve(const std::vector<site>& sites,
                                             const bounding_box& box) {
  std::vector<std::uint32_t> order = all_numbers(sites.size());
  sort_along_curve(order, sites, box);
  return order;
}

void sort_along_curve(std::vector<site>& sites, const bounding_box& box) {
  std::vector<site> sorted;
  sorted.reserve(sites.size());
  for (const std::uint32_t i : order_along_curve(sites, box)) sorted.push_back(sites[i]);
  sites = std::move(sorted);
}

}  // namespace asterism::internal
