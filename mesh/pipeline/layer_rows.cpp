// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/layer_rows.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/metric/wall_layers.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/place_tree.hpp"

namespace asterism {
using namespace internal;
namespace {

constexpr double least_part_of_height = 0.9;
constexpr double least_distance = 0.7;  // metric length

std::vector<sized_place> segments_of(const domain& d) {
  std::vector<sized_place> places;
  for (const segment& s : d.segments) places.push_back({d.vertices[s.a], d.vertices[s.b]});
  return places;
}

// Vertices inside the domain, indexed by their place.
class inner_vertices {
 public:
  explicit inner_vertices(const domain& d) : index_(d.box()) {
    std::vector<char> on_segment(d.vertices.size(), 0);
    for (const segment& s : d.segments) on_segment[s.a] = on_segment[s.b] = 1;
    for (std::size_t v = 0; v < d.vertices.size(); ++v)
      if (on_segment[v] == 0) add(d.vertices[v]);
  }

  void add(const point& q) {
    index_.insert(static_cast<std::uint32_t>(places_.size()), {q, q});
    places_.push_back(q);
  }
  // True if some vertex is nearer to s than the metric length `distance`, as s measures it.
  bool has_near(const site& s, double distance) const {
    return !index_.visit(box_around(s, distance), [&](std::uint32_t i) {
      return squared_distance(s, places_[i]) >= distance * distance;
    });
  }

 private:
  box_index index_;
  std::vector<point> places_;
};

// Returns the point at this height over the middle of p and q, on their left.
point over_middle(const point& p, const point& q, double height) {
  const double x = q.x - p.x, y = q.y - p.y, length = std::sqrt(x * x + y * y);
  return {p.x + x / 2 - height * (y / length), p.y + y / 2 + height * (x / length)};
}

}  // namespace

result<domain> with_layer_rows(domain d, const size_wishes& wishes, const metric_field& field,
                               std::size_t most) {
  const std::vector<wall_side> sides = wall_sides(d, wishes.layers);
  if (sides.empty()) return d;
  const auto divided = divide_segments(d, field, 1, most);
  if (!divided) return divided.failure();
  if (divided.value().of_each.empty()) return d;
  const place_tree segments(segments_of(d));
  const inside_index inside(d);
  inner_vertices vertices(d);
  const std::size_t room = d.vertices.size() + most;
  for (const wall_side& side : sides) {
    const std::vector<point>& points = divided.value().of_each[side.segment].points;
    const bool is_forward = side.a == d.segments[side.segment].a;
    const double height = wishes.layers[side.wish].first_height;
    for (std::size_t i = 0; i + 1 < points.size() && d.vertices.size() < room; ++i) {
      const point q = is_forward ? over_middle(points[i], points[i + 1], height)
                                 : over_middle(points[i + 1], points[i], height);
      if (segments.least_at(q).size < least_part_of_height * height || !inside.contains(q))
        continue;
      const auto metric = field.at(q);
      if (!metric) return metric.failure();
      if (vertices.has_near({q, metric.value()}, least_distance)) continue;
      vertices.add(q);
      d.vertices.push_back(q);
    }
  }
  return d;
}

}  // namespace asterism
