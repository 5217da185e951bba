// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/hull_bounds.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

rounded_interval share_of(int part, int whole) {
  return quotient(rounded_interval(part), rounded_interval(whole));
}

double polynomial_gap(const triangle_net& net, const interval_triangle& corners) {
  const int n = net.degree;
  std::array<rounded_interval, 2 * most_degree + 1> shares;
  for (int k = 0; k <= n; ++k) shares[static_cast<std::size_t>(k)] = share_of(k, n);
  double most = 0;
  std::size_t at = 0;
  for (int i = n; i >= 0; --i)
    for (int j = n - i; j >= 0; --j, ++at) {
      const interval_vector flat = shares[static_cast<std::size_t>(i)] * corners[0] +
                                   shares[static_cast<std::size_t>(j)] * corners[1] +
                                   shares[static_cast<std::size_t>(n - i - j)] * corners[2];
      most = std::max(most, squared_length(net.points[at].at - flat).sup());
    }
  return most;
}

double rational_gap(const triangle_net& net, const interval_triangle& corners) {
  const int n = net.degree + 1;
  double most = 0;
  for (int i = n; i >= 0; --i)
    for (int j = n - i; j >= 0; --j) {
      const std::array<int, 3> index = {i, j, n - i - j};
      interval_vector difference{};
      rounded_interval weight = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (index[k] == 0) continue;
        const rounded_interval share = share_of(index[k], n);
        const weighted_point& c = net.points[net_index(net.degree, i - (k == 0), j - (k == 1))];
        difference = difference + share * (c.weight * corners[k] - c.at);
        weight = weight + share * c.weight;
      }
      most = std::max(most, quotient(squared_length(difference), squared(weight)).sup());
    }
  return most;
}

}  // namespace

double squared_gap_above(const triangle_net& net, bool is_rational,
                         const interval_triangle& corners) {
  return is_rational ? rational_gap(net, corners) : polynomial_gap(net, corners);
}

std::vector<interval_vector> euclidean(const weighted_point* points, std::size_t count,
                                       bool is_rational) {
  std::vector<interval_vector> all(count);
  for (std::size_t k = 0; k < count; ++k)
    all[k] = is_rational ? quotient(points[k].at, points[k].weight) : points[k].at;
  return all;
}

hull_distance hull_distance_above(const std::vector<interval_vector>& points,
                                  const plain_triangle& triangle) {
  hull_distance most;
  const distances_above from(triangle);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double far = from.of(points[k]);
    if (far > most.squared) most = {far, k};
  }
  return most;
}

double hull_distance_above(const std::vector<interval_vector>& points, const two_triangles& two) {
  const plain_triangle first = {two.common[0], two.common[1], two.first},
                       second = {two.common[0], two.common[1], two.second};
  const plain_vector x = plain(two.common[0]), y = plain(two.common[1]);
  const plain_vector e = y - x, a = plain(two.first) - x, b = plain(two.second) - x;
  // Chooses a plane that contains the edge and about halves the angle between the triangles; any
  // plane is valid.
  const double length = dot(e, e);
  if (!(length > 0)) return hull_distance_above(points, first).squared;
  const plain_vector across_a = a - (dot(a, e) / length) * e,
                     across_b = b - (dot(b, e) / length) * e;
  const double size_a = dot(across_a, across_a), size_b = dot(across_b, across_b);
  if (!(size_a > 0) || !(size_b > 0)) return hull_distance_above(points, first).squared;
  const plain_vector normal =
      (1 / rounded_root(size_b)) * across_b - (1 / rounded_root(size_a)) * across_a;
  const interval_vector g{normal.x, normal.y, normal.z},
      from = vector_of<rounded_interval>(two.common[0]);
  const distances_above from_first(first), from_second(second);
  std::vector<rounded_interval> heights(points.size());
  double most = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    heights[k] = dot(g, points[k] - from);
    if (!(heights[k].inf() > 0)) most = std::max(most, from_first.of(points[k]));
    if (!(heights[k].sup() < 0)) most = std::max(most, from_second.of(points[k]));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(heights[i].sup() < 0)) continue;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (!(heights[j].inf() > 0)) continue;
      const rounded_interval share = quotient(-heights[i], heights[j] - heights[i]);
      const interval_vector crossing = points[i] + share * (points[j] - points[i]);
      most = std::max({most, from_first.of(crossing), from_second.of(crossing)});
    }
  }
  return most;
}

}  // namespace asterism::internal
