// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/gap_geometry.hpp"

#include <cmath>

namespace asterism::internal::proof_detail {

offset from(const site& v, const site& z) {
  return {z.position.x - v.position.x, z.position.y - v.position.y};
}

offset in_basis(const offset& p, const offset& x, const offset& y) {
  const double area = cross(x, y);
  return {cross(p, y) / area, cross(x, p) / area};
}

offset voronoi_vertex(const site& v, const site& x, const site& y) {
  const offset to_x = from(v, x), to_y = from(v, y);
  const tensor<double> own(v.metric), by_x(x.metric), by_y(y.metric);
  tensor<double> sum = own;
  sum.m11 += by_x.m11 + by_y.m11;
  sum.m12 += by_x.m12 + by_y.m12;
  sum.m22 += by_x.m22 + by_y.m22;
  const auto solve = [](const offset& a, const offset& b, double of_a, double of_b) {
    const double inverse = 1 / cross(a, b);
    return offset{inverse * (of_a * b.y - of_b * a.y), inverse * (of_b * a.x - of_a * b.x)};
  };
  offset u = solve(sum * to_x, sum * to_y, sum.square(to_x) / 2, sum.square(to_y) / 2);
  constexpr int steps = 6;
  for (int i = 0; i < steps; ++i) {
    const offset from_x = u - to_x, from_y = u - to_y;
    const offset slope_x = by_x * from_x - own * u, slope_y = by_y * from_y - own * u;
    const double square = own.square(u);
    const offset step = solve(slope_x, slope_y, (square - by_x.square(from_x)) / 2,
                              (square - by_y.square(from_y)) / 2);
    const offset nearer = u + step;
    if (!(std::isfinite(nearer.x) && std::isfinite(nearer.y))) break;
    u = nearer;
  }
  return u;
}

std::optional<std::int32_t> on_grid(double part, double least) {
  const double steps = std::ceil(part / grid_step);
  if (!(steps >= least && steps <= 0x1p31 - 256)) return std::nullopt;
  return static_cast<std::int32_t>(steps);
}

double first_meeting(const site& v, const offset& z, const site& at, const offset& u) {
  const tensor<double> own(v.metric), other(at.metric);
  const double c = other.square(z), along = dot(u, other * z),
               radicand = along * along + c * (own.square(u) - other.square(u));
  return radicand >= 0 ? (along + std::sqrt(radicand)) / c : -1;
}

std::optional<proof_point> point_along(const offset& part, double bound, double slack) {
  if (!(bound > 0)) return std::nullopt;
  const double far = (1 + slack) / bound;
  const auto a = on_grid(part.x * far, 0), b = on_grid(part.y * far, 0);
  if (!a || !b) return std::nullopt;
  return proof_point{*a, *b};
}

double part_of_edge(const site& v, const offset& z, const site& at, const offset& q) {
  const tensor<double> own(v.metric), other(at.metric);
  const double first = 1 / first_meeting(v, z, at, z);
  // Uses the polar form of f_v - f_z in the points q and t z, which is slope t + constant. It is
  // zero where the bisector's tangent at q meets the edge.
  const double constant = dot(other * z, q - z), slope = dot(own * z, q) - constant;
  const double tangent = -constant / slope;
  return slope > 0 && tangent > first ? tangent : first;
}

}  // namespace asterism::internal::proof_detail
