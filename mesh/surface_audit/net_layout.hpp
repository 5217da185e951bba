// SPDX-License-Identifier: MIT
//
// Defines the order of the points of a net over a triangle, and its sources.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

// A corner in a piece's own parameters; exact corners are points, others intervals.
struct parameter_corner {
  rounded_interval s, t;
};
using parameter_triangle = std::array<parameter_corner, 3>;

// Returns the index of the multi-index (i, j, n - i - j) among those of sum n: by i descending,
// then j descending. (n, 0, 0) is the first, (0, 0, n) the last.
inline std::size_t net_index(int n, int i, int j) {
  const auto rest = static_cast<std::size_t>(n - i);
  return rest * (rest + 1) / 2 + (rest - static_cast<std::size_t>(j));
}
constexpr std::size_t net_size(int n) { return static_cast<std::size_t>((n + 1) * (n + 2) / 2); }

struct triangle_net {
  int degree = 0;
  std::vector<weighted_point> points;
};

// Refers to (degree_u + 1)(degree_v + 1) control points, in rows, of a piece or of a derivative.
struct tensor_net {
  int degree_u = 0, degree_v = 0;
  const weighted_point* points = nullptr;
};
inline tensor_net tensor_of(const bezier_piece& p) {
  return {p.degree_u, p.degree_v, p.net.data()};
}

}  // namespace asterism::internal
