// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric_field_featured.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/mesh/constructions.hpp"
#include "asterism/mesh/local/neighbourhood.hpp"

namespace asterism {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Segments of one length stay whole, and triangles grow as they would by Delaunay refinement.
constexpr double part_of_segment = 1.3, growth = 0.7;

}  // namespace

result<featured_field> featured_field::make(const domain& d, const metric_field& field,
                                            double longest) {
  featured_field made(field, longest);
  made.box_ = d.box();
  for (const point& q : d.vertices) {
    const auto metric = field.at(q);
    if (!metric) return metric.failure();
    made.vertices_.push_back({q, metric.value()});
  }
  made.shorter_.assign(d.vertices.size(), infinity);
  for (const segment& s : d.segments)
    for (const auto& [v, w] : {std::pair{s.a, s.b}, std::pair{s.b, s.a}}) {
      const double length = std::sqrt(squared_distance(made.vertices_[v], d.vertices[w]));
      made.shorter_[v] = std::min(made.shorter_[v], length);
    }
  for (index v = 0; v < made.vertices_.size(); ++v) {
    if (!(made.shorter_[v] > 0 && made.shorter_[v] < infinity)) continue;
    const auto [at, is_new] = made.octaves_.try_emplace(std::ilogb(made.shorter_[v]));
    if (is_new) at->second = site_index(made.box_);
    at->second.insert(made.vertices_, v);
  }
  return made;
}

result<metric_tensor> featured_field::at(const point& q) const {
  auto metric = field_->at(q);
  if (!metric) return metric;
  const metric_tensor& m = metric.value();
  const double h = length_at({q, m}), inverse = 1 / (h * h);
  if (!(inverse > 0 && inverse < infinity)) return metric;
  return metric_tensor{m.m11 * inverse, m.m12 * inverse, m.m22 * inverse};
}

double featured_field::length_at(const site& q) const {
  double least = longest_;
  for (const auto& [exponent, vertices] : octaves_) {
    const double shortest = part_of_segment * std::ldexp(1.0, exponent);
    // Boxes twice as large each time, until no vertex outside could matter.
    constexpr int most_boxes = 2200;  // doubles have no more octaves
    double reach = shortest;
    for (int i = 0; i < most_boxes && shortest < least; ++i, reach *= 2) {
      const double radius = std::min(reach, (least - shortest) / growth);
      const bounding_box near = box_around(q, radius);
      vertices.visit_box(vertices_, near.low, near.high, [&](index v) {
        const double distance = std::sqrt(squared_distance(q, vertices_[v].position));
        least = std::min(least, part_of_segment * shorter_[v] + growth * distance);
        return true;
      });
      const bool all = near.low.x <= box_.low.x && near.low.y <= box_.low.y &&
                       near.high.x >= box_.high.x && near.high.y >= box_.high.y;
      // A vertex outside is farther than the radius.
      if (all || shortest + growth * radius >= least) break;
    }
  }
  return least;
}

}  // namespace asterism
