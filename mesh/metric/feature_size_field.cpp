// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/feature_size_field.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <utility>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Size at a vertex as a multiple of its shorter segment, and growth of the size with distance:
// segments of one length stay whole, and triangles grow as in Delaunay refinement.
constexpr double part_of_segment = 1.3, growth = 0.7;

}  // namespace

result<featured_field> featured_field::make(const domain& d, const metric_field& field,
                                            double longest) {
  featured_field made(field, longest);
  std::vector<site> vertices;
  for (const point& q : d.vertices) {
    const auto metric = field.at(q);
    if (!metric) return metric.failure();
    vertices.push_back({q, metric.value()});
  }
  std::vector<double> shorter(vertices.size(), infinity);
  for (const segment& s : d.segments)
    for (const auto& [v, w] : {std::pair{s.a, s.b}, std::pair{s.b, s.a}})
      shorter[v] = std::min(shorter[v], std::sqrt(squared_distance(vertices[v], d.vertices[w])));
  for (vertex_index v = 0; v < vertices.size(); ++v)
    if (shorter[v] > 0 && shorter[v] < infinity)
      made.features_.push_back({vertices[v].position, shorter[v]});
  if (!made.features_.empty()) made.add_node(0, made.features_.size());
  return made;
}

// Builds a node of the tree. Halves the features along the longer side of the box, so that the
// depth is bounded.
void featured_field::add_node(std::size_t first, std::size_t last) {
  constexpr std::size_t leaf_size = 8;
  const std::size_t self = nodes_.size();
  node n{{features_[first].vertex, features_[first].vertex}, infinity, first, last, 0};
  for (std::size_t i = first; i < last; ++i) {
    n.box.include(features_[i].vertex);
    n.shortest = std::min(n.shortest, features_[i].shorter);
  }
  nodes_.push_back(n);
  if (last - first <= leaf_size) return;
  const bool is_wide = n.box.high.x - n.box.low.x > n.box.high.y - n.box.low.y;
  const auto middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return features_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](const feature& a, const feature& b) {
    const point &p = a.vertex, &q = b.vertex;
    return is_wide ? std::pair(p.x, p.y) < std::pair(q.x, q.y)
                   : std::pair(p.y, p.x) < std::pair(q.y, q.x);
  });
  add_node(first, middle);
  nodes_[self].second_child = nodes_.size();
  add_node(middle, last);
}

result<metric_tensor> featured_field::at(const point& q) const {
  auto metric = field_->at(q);
  if (!metric) return metric;
  const metric_tensor& m = metric.value();
  const double h = length_at({q, m}), inverse = 1 / (h * h);
  if (!(inverse > 0 && inverse < infinity)) return metric;
  return metric_tensor{m.m11 * inverse, m.m12 * inverse, m.m22 * inverse};
}

// Visits nearer children first. The distance to a box is at least the larger of those in x and y,
// divided by the half extents of the unit ellipse.
double featured_field::length_at(const site& q) const {
  constexpr double near_enough = 1 / 1.16;
  const metric_tensor& m = q.metric;
  const double determinant = m.m11 * m.m22 - m.m12 * m.m12;
  const double narrow_x = std::sqrt(determinant / m.m22), narrow_y = std::sqrt(determinant / m.m11);
  const auto least_at = [&](std::size_t at) {
    const node& n = nodes_[at];
    const point &p = q.position, &low = n.box.low, &high = n.box.high;
    const double x = std::max({low.x - p.x, p.x - high.x, 0.0});
    const double y = std::max({low.y - p.y, p.y - high.y, 0.0});
    return part_of_segment * n.shortest + growth * std::max(narrow_x * x, narrow_y * y);
  };
  double least = longest_;
  if (nodes_.empty()) return least;
  // Size of the stack: depths are at most the logarithm of the number of features.
  boost::container::small_vector<std::pair<std::size_t, double>, 64> waiting{{0, least_at(0)}};
  while (!waiting.empty()) {
    const auto [at, bound] = waiting.back();
    waiting.pop_back();
    if (bound >= near_enough * least) continue;
    const node& n = nodes_[at];
    if (n.second_child == 0) {
      for (std::size_t i = n.first; i < n.last; ++i)
        least = std::min(least, part_of_segment * features_[i].shorter +
                                    growth * std::sqrt(squared_distance(q, features_[i].vertex)));
      continue;
    }
    std::pair first{at + 1, least_at(at + 1)}, second{n.second_child, least_at(n.second_child)};
    if (first.second < second.second) std::swap(first, second);
    waiting.push_back(first);
    waiting.push_back(second);
  }
  return least;
}

}  // namespace asterism::internal
