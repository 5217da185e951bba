// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit_site_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace asterism::audit_detail {
namespace {

constexpr std::size_t leaf_size = 4;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Distance along one axis from x to [low, high], as an exact-or-bounded number.
bounded axis_distance(double x, double low, double high) {
  if (x < low) return bounded(low) - bounded(x);
  if (x > high) return bounded(x) - bounded(high);
  return {0.0};
}

// Below |q - v|_v^2 for every q of the box. With dx fixed the least of the quadratic form is
// (det / m22) dx^2, with dy fixed (det / m11) dy^2.
bounded least_length_squared(const metric_tensor& metric, const bounded& dx, const bounded& dy) {
  const bounded determinant = tensor_of_doubles(metric).determinant();
  const bounded by_x = determinant / bounded(metric.m22) * dx * dx;
  const bounded by_y = determinant / bounded(metric.m11) * dy * dy;
  return by_x.lower() > by_y.lower() ? by_x : by_y;
}

}  // namespace

site_tree::site_tree(const std::vector<site>& sites) : order_(sites.size()) {
  std::iota(order_.begin(), order_.end(), index{0});
  nodes_.reserve(2 * sites.size() / leaf_size + 1);
  if (!sites.empty()) build(0, sites.size(), sites);
}

void site_tree::bound(node& n, const std::vector<site>& sites) const {
  n.low = {infinity, infinity};
  n.high = {-infinity, -infinity};
  n.inverse12_low = infinity;
  n.inverse12_high = -infinity;
  n.inverse_determinant = infinity;
  for (std::size_t i = n.first; i < n.last; ++i) {
    const site& s = sites[order_[i]];
    n.low = {std::min(n.low.x, s.position.x), std::min(n.low.y, s.position.y)};
    n.high = {std::max(n.high.x, s.position.x), std::max(n.high.y, s.position.y)};
    const bounded inverse = bounded(1) / tensor_of_doubles(s.metric).determinant();
    const bounded i12 = -bounded(s.metric.m12) * inverse;
    n.inverse11 = greatest_bound(n.inverse11, (bounded(s.metric.m22) * inverse).upper());
    n.inverse22 = greatest_bound(n.inverse22, (bounded(s.metric.m11) * inverse).upper());
    n.inverse12_low = -greatest_bound(-n.inverse12_low, -i12.lower());
    n.inverse12_high = greatest_bound(n.inverse12_high, i12.upper());
    n.inverse_determinant = std::min(n.inverse_determinant, positive_bound(inverse.lower()));
  }
}

void site_tree::build(std::size_t first, std::size_t last, const std::vector<site>& sites) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  nodes_[self].first = first;
  nodes_[self].last = last;
  bound(nodes_[self], sites);
  if (last - first <= leaf_size) return;
  const std::size_t middle = first + (last - first) / 2;
  const point low = nodes_[self].low, high = nodes_[self].high;
  // Halved, as the difference of two finite doubles may overflow. The order decides cost alone,
  // and is total because positions are distinct.
  const bool wide = high.x / 2 - low.x / 2 > high.y / 2 - low.y / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](index a, index b) {
    const point &p = sites[a].position, &q = sites[b].position;
    if (wide) return lexicographically_less(p, q);
    return p.y < q.y || (p.y == q.y && p.x < q.x);
  });
  build(first, middle, sites);
  nodes_[self].right = nodes_.size();
  build(middle, last, sites);
}

bool site_tree::too_far(const node& n, const site& v, const star_reach& reach) {
  const bounded dx = axis_distance(v.position.x, n.low.x, n.high.x);
  const bounded dy = axis_distance(v.position.y, n.low.y, n.high.y);
  const bounded length = root(least_length_squared(v.metric, dx, dy));
  const metric_tensor& m = v.metric;
  // Upper bounds of the trace, a lower one of the determinant of M_w^-1 M_v: its larger eigenvalue
  // grows with the first and falls with the second.
  const bounded trace =
      bounded(n.inverse11) * bounded(m.m11) +
      bounded(m.m12 > 0 ? n.inverse12_high : n.inverse12_low) * bounded(2) * bounded(m.m12) +
      bounded(n.inverse22) * bounded(m.m22);
  const bounded determinant = bounded(n.inverse_determinant) * tensor_of_doubles(m).determinant();
  const bounded half = trace * bounded(0.5);
  const bounded sigma = root(half + root(half * half - determinant));
  return certainly_less((sigma + bounded(1)) * bounded(reach.radius), length) &&
         certainly_less((sigma + bounded(2)) * bounded(reach.longest), length);
}

std::vector<index> site_tree::near(const site& v, const star_reach& reach) const {
  std::vector<index> result;
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::size_t self = open.back();
    const node& n = nodes_[self];
    open.pop_back();
    if (too_far(n, v, reach)) continue;
    if (n.right == 0) {
      for (std::size_t i = n.first; i < n.last; ++i) result.push_back(order_[i]);
    } else {
      open.push_back(self + 1);
      open.push_back(n.right);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace asterism::audit_detail
