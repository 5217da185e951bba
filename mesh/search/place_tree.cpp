// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/place_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "asterism/mesh/support/double_double.hpp"

namespace asterism::internal {
namespace {

constexpr std::uint32_t leaf_size = 4;

double length(double x, double y) { return std::sqrt(x * x + y * y); }

double distance_from_box(const point& q, const bounding_box& box) {
  const double x = std::max({box.low.x - q.x, q.x - box.high.x, 0.0}),
               y = std::max({box.low.y - q.y, q.y - box.high.y, 0.0});
  return length(x, y);
}

bounding_box box_of_place(const sized_place& p) {
  return {{std::min(p.a.x, p.b.x) - p.radius, std::min(p.a.y, p.b.y) - p.radius},
          {std::max(p.a.x, p.b.x) + p.radius, std::max(p.a.y, p.b.y) + p.radius}};
}

// Returns the parameter, from 0 at a to 1 at b, of the foot of the perpendicular from q on the
// segment.
double foot_on(const point& q, const point& a, const point& b) {
  const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
  if (!(squared > 0)) return 0;
  return ((q.x - a.x) * x + (q.y - a.y) * y) / squared;
}

// Returns the distance of q from the line through a and b. The difference of the two products
// cancels where q is near the line, so that products and differences of coordinates are computed to
// twice as many bits.
double distance_from_line(const point& q, const point& a, const point& b) {
  const double_double x = double_double(b.x) - a.x, y = double_double(b.y) - a.y;
  const double_double cross = x * (double_double(q.y) - a.y) - y * (double_double(q.x) - a.x);
  return std::abs(static_cast<double>(cross)) / length(b.x - a.x, b.y - a.y);
}

double distance_from_segment(const point& q, const point& a, const point& b) {
  const double t = foot_on(q, a, b);
  if (t <= 0) return length(q.x - a.x, q.y - a.y);
  if (t >= 1) return length(q.x - b.x, q.y - b.y);
  return distance_from_line(q, a, b);
}

double size_at(const point& q, const sized_place& p) {
  return p.size + p.slope * distance_from(q, p);
}

}  // namespace

point nearest_on_segment(const point& q, const point& a, const point& b) {
  const double t = foot_on(q, a, b);
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double distance_from(const point& q, const sized_place& place) {
  const double distance = place.is_box ? distance_from_box(q, {place.a, place.b})
                                       : distance_from_segment(q, place.a, place.b);
  return std::max(distance - place.radius, 0.0);
}

place_tree::place_tree(std::vector<sized_place> places)
    : places_(std::move(places)), order_(places_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) add_node(0, static_cast<std::uint32_t>(order_.size()));
}

// Adds the node of the places number `first` to `last` - 1 of order_, and below it the nodes of the
// two halves of these places, divided along the longer side of the node's box. Depth: the logarithm
// of the number of places.
void place_tree::add_node(std::uint32_t first, std::uint32_t last) {
  const std::size_t at = nodes_.size();
  node made{box_of_place(places_[order_[first]]),
            std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity(),
            first,
            last,
            0};
  for (std::uint32_t i = first; i < last; ++i) {
    const sized_place& p = places_[order_[i]];
    made.box.include(box_of_place(p));
    made.size = std::min(made.size, p.size);
    made.slope = std::min(made.slope, p.slope);
  }
  nodes_.push_back(made);
  if (last - first <= leaf_size) return;
  const bool along_x = made.box.high.x - made.box.low.x >= made.box.high.y - made.box.low.y;
  const auto middle_of = [&](std::uint32_t i) {
    const sized_place& p = places_[i];
    return along_x ? p.a.x / 2 + p.b.x / 2 : p.a.y / 2 + p.b.y / 2;
  };
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) {
                     return std::pair(middle_of(i), i) < std::pair(middle_of(j), j);
                   });
  add_node(first, half);
  nodes_[at].second_child = static_cast<std::uint32_t>(nodes_.size());
  add_node(half, last);
}

// Returns a lower bound of the sizes that the node's places allow at q, with the operations of
// size_at.
double place_tree::bound_at(const node& n, const point& q) {
  // Subtracts more than the rounding of both distances, some units of 2^-53 each.
  constexpr double below = 1 - 0x1p-40;
  return below * (n.size + n.slope * distance_from_box(q, n.box));
}

place_tree::found place_tree::least_at(const point& q) const {
  found best;
  // Size of the stack of a descent: each level leaves one other node waiting.
  std::array<std::uint32_t, 64> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t at = open[--waiting];
    const node& n = nodes_[at];
    if (bound_at(n, q) > best.size) continue;
    if (n.second_child != 0) {
      const std::uint32_t first = at + 1, second = n.second_child;
      const bool first_is_nearer = bound_at(nodes_[first], q) <= bound_at(nodes_[second], q);
      open[waiting++] = first_is_nearer ? second : first;
      open[waiting++] = first_is_nearer ? first : second;
      continue;
    }
    for (std::uint32_t i = n.first; i < n.last; ++i) {
      const std::uint32_t place = order_[i];
      const double size = size_at(q, places_[place]);
      if (size < best.size || (size == best.size && place < best.place)) best = {place, size};
    }
  }
  return best;
}

}  // namespace asterism::internal
