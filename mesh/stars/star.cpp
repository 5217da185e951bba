// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

// Sector of directions that v -> u lies in, counter-clockwise from the ray v -> first: the ray, an
// open half plane, the opposite ray, or the other half plane. Directions within one half plane are
// ordered by one orientation.
enum class half { on_first_ray, left, on_opposite_ray, right };

half half_of(const site_oracle& oracle, vertex_index v, vertex_index first, vertex_index u) {
  if (u == first) return half::on_first_ray;
  switch (oracle.orientation(v, first, u)) {
    case sign::positive:
      return half::left;
    case sign::negative:
      return half::right;
    case sign::zero:
      break;
  }
  return oracle.same_direction(v, first, u) ? half::on_first_ray : half::on_opposite_ray;
}

// Compares the direction of w with that of neighbour u, counter-clockwise from the first: negative
// before it, zero on its ray, positive after it.
sign compare_direction(const site_oracle& oracle, vertex_index v, vertex_index first,
                       vertex_index u, half half_of_w, vertex_index w) {
  const half half_of_u = half_of(oracle, v, first, u);
  if (half_of_u != half_of_w) return half_of_u < half_of_w ? sign::positive : sign::negative;
  if (half_of_w == half::on_first_ray || half_of_w == half::on_opposite_ray) return sign::zero;
  return oracle.orientation(v, u, w);
}

}  // namespace

bool star::contains(vertex_index w) const {
  return std::any_of(sectors.begin(), sectors.end(), [w](const sector& s) {
    return std::find(s.neighbours.begin(), s.neighbours.end(), w) != s.neighbours.end();
  });
}

star empty_star(const boundary& edges, vertex_index v) {
  star s;
  for (const boundary_corner& c : edges.corners(v)) s.sectors.push_back({{c.first, c.last}, false});
  if (s.sectors.empty()) s.sectors.push_back({{}, true});
  return s;
}

placement locate(const site_oracle& oracle, vertex_index v, const sector& s, vertex_index w) {
  if (s.neighbours.empty()) return {placement_kind::in_gap, 0};
  const vertex_index first = s.neighbours.front();
  const half half_of_w = half_of(oracle, v, first, w);
  if (half_of_w == half::on_first_ray) return {placement_kind::on_ray, 0};
  // Keeps neighbour `low` before w and neighbour `high` after it. The last neighbour of a slit,
  // which is the first one again, is after every direction.
  std::size_t low = 0, high = s.is_slit() ? s.size() - 1 : s.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    switch (compare_direction(oracle, v, first, s.neighbours[middle], half_of_w, w)) {
      case sign::zero:
        return {placement_kind::on_ray, middle};
      case sign::positive:
        low = middle;
        break;
      case sign::negative:
        high = middle;
        break;
    }
  }
  if (!s.closed && high == s.size()) return {placement_kind::outside, 0};
  return {placement_kind::in_gap, low};
}

bool holds_triangle(const site_oracle& oracle, vertex_index v, const sector& s, std::size_t gap) {
  if (s.size() < 2) return false;
  return oracle.orientation(v, s.neighbours[gap], s.neighbours[s.after(gap)]) == sign::positive;
}

std::optional<std::size_t> gap_from(const site_oracle& oracle, vertex_index v, const sector& s,
                                    vertex_index y, vertex_index x) {
  // Number of neighbours above which a bisection is cheaper than comparing each; few stars have as
  // many.
  constexpr std::size_t many = 64;
  const auto is_from = [&](std::size_t gap) {
    return gap < s.gaps() && s.neighbours[gap] == y && s.neighbours[s.after(gap)] == x;
  };
  if (s.neighbours.empty() || y == v) return std::nullopt;
  if (s.size() > many) {
    const placement at = locate(oracle, v, s, y);
    if (at.kind == placement_kind::on_ray && is_from(at.at)) return at.at;
    return std::nullopt;
  }
  for (std::size_t gap = 0; gap < s.gaps(); ++gap)
    if (is_from(gap)) return gap;
  return std::nullopt;
}

bool has_triangle(const site_oracle& oracle, vertex_index v, const star& s, vertex_index y,
                  vertex_index x) {
  for (const sector& part : s.sectors)
    if (const auto gap = gap_from(oracle, v, part, y, x))
      return holds_triangle(oracle, v, part, *gap);
  return false;
}

}  // namespace asterism::internal
