// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_outline.hpp"

namespace asterism::internal::audit_detail {
namespace {

// `eight_roundings` times the sum of a value's absolute monomials bounds as many roundings in any
// rounding mode, `four_more` the three or four roundings after that (site_tree.cpp).
constexpr double eight_roundings = 0x1p-48, four_more = 1 + 0x1p-49, most_extent = 0x1p200;

// Returns the vertex that is nearest to the place in the metric. Compares squares of distances,
// less those of the vertices' lengths.
const point& nearest_vertex(const point& to, const least_metric& metric,
                            std::span<const outline_point> vertices) {
  const metric_tensor& m = metric.tensor;
  const outline_point* best = vertices.data();
  double least = 0;
  for (const outline_point& p : vertices) {
    const double x = to.x - p.at.x, y = to.y - p.at.y;
    const double power =
        (m.m11 * x + 2 * m.m12 * y) * x + m.m22 * y * y - metric.factor * (p.length * p.length);
    if (&p != vertices.data() && !(power < least)) continue;
    least = power;
    best = &p;
  }
  return best->at;
}

}  // namespace

// With g = A h, A the tensor, |g|_w^2 is at most g . h times the factor. The computed g has an
// error of at most `eight_roundings` times its magnitudes; h need not be exact.
bool are_outside(const offset_box& to, const least_metric& metric,
                 std::span<const outline_point> vertices, std::span<const outline_point> others) {
  const auto& [low, high] = to;
  const point middle{0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y};
  const point& from = nearest_vertex(middle, metric, vertices);
  const point h{middle.x - from.x, middle.y - from.y};
  const metric_tensor& m = metric.tensor;
  const point g{m.m11 * h.x + m.m12 * h.y, m.m12 * h.x + m.m22 * h.y};
  const point size{m.m11 * std::abs(h.x) + std::abs(m.m12 * h.y),
                   std::abs(m.m12 * h.x) + m.m22 * std::abs(h.y)};
  const auto error = [&size](double x, double y) {
    return eight_roundings * (size.x * x + size.y * y);
  };
  const point far{std::max(std::abs(low.x), std::abs(high.x)),
                  std::max(std::abs(low.y), std::abs(high.y))};
  const double least =
      g.x * (g.x > 0 ? low.x : high.x) + g.y * (g.y > 0 ? low.y : high.y) - error(far.x, far.y);
  const bool in_range = least > 0x1p-300 && size.x + size.y < most_extent &&
                        far.x + far.y < most_extent && metric.factor < most_extent;
  if (!in_range) return false;
  const double squared = g.x * h.x + g.y * h.y + error(std::abs(h.x), std::abs(h.y)) + 0x1p-300;
  const double length = std::sqrt(squared * metric.factor) * (four_more * four_more);
  const auto is_below = [&](const outline_point& p) {
    const double value = g.x * p.at.x + g.y * p.at.y + length * p.length;
    return value + error(std::abs(p.at.x), std::abs(p.at.y)) < least;
  };
  return std::all_of(vertices.begin(), vertices.end(), is_below) &&
         std::all_of(others.begin(), others.end(), is_below);
}

}  // namespace asterism::internal::audit_detail
