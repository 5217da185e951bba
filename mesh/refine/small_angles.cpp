// SPDX-License-Identifier: MIT
//
// The part of refine_state that knows narrow wedges: two segments at a sharp corner as far as they
// go. In a wedge each split of one segment encroaches on the other; points at the same distances
// from the corner on both make that end (docs/design/refinement.md, "Corners").
#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/refine_state.hpp"

namespace asterism::internal {
namespace {

constexpr double sharp_angle = 60;  // degrees
// Wider ones, and those without an internal segment, have room to mend their triangles.
constexpr double mirrored_angle = 10;

double distance_from(const site& corner, const point& q) {
  return std::sqrt(squared_distance(corner, q));
}

// The point of the segment from `near` to `far` that is at this distance from the corner they are
// in line with, whose distances are given.
std::optional<point> point_between(const point& near, const point& far, double near_distance,
                                   double far_distance, double wanted) {
  if (!(near_distance < wanted && wanted < far_distance)) return std::nullopt;
  const double part = (wanted - near_distance) / (far_distance - near_distance);
  const double x = near.x + part * (far.x - near.x), y = near.y + part * (far.y - near.y);
  return point{std::clamp(x, std::min(near.x, far.x), std::max(near.x, far.x)),
               std::clamp(y, std::min(near.y, far.y), std::max(near.y, far.y))};
}

// Of the multiples of powers of two in the middle half of [low, high] that of the greatest power,
// the one nearest to the middle; 0 < low < high.
double coarsest_in_middle(double low, double high) {
  const double quarter = (high - low) / 4, middle = low + 2 * quarter;
  // One of two neighbouring multiples is in an interval at least as long as their distance.
  double step = elementary::exp2(std::ceil(elementary::log2(high)));
  for (int i = 0; i < 64; ++i, step /= 2) {
    const double multiple = step * std::round(middle / step);
    if (std::abs(multiple - middle) <= quarter) return multiple;
  }
  return middle;
}

}  // namespace

void refine_state::find_wedges() {
  struct ends {
    vertex_index a = 0, b = 0;
    bool internal = false;
  };
  std::vector<ends> segments;
  for (const boundary_edge& p : edges_.subsegments()) {
    if (segments.size() <= p.segment) segments.resize(p.segment + 1);
    segments[p.segment] = {p.a, p.b, p.internal};
  }
  wedges_of_segment_.resize(segments.size());
  for (const domain_corner& c : corners_) {
    if (!(c.angle < sharp_angle)) continue;
    const auto [leaving, entering] = subsegments_at(c);
    domain_wedge w{c, edges_.subsegments()[leaving].segment,
                   edges_.subsegments()[entering].segment};
    const ends &first = segments[w.first], &last = segments[w.last];
    w.first_end = first.a == c.vertex ? first.b : first.a;
    w.last_end = last.a == c.vertex ? last.b : last.a;
    w.internal = first.internal || last.internal;
    wedges_of_segment_[w.first].push_back(wedges_.size());
    wedges_of_segment_[w.last].push_back(wedges_.size());
    wedges_.push_back(w);
  }
}

bool refine_state::is_narrower(const domain_wedge& w, vertex_index v, double degrees) const {
  constexpr double guard = 1 - 1e-9;
  const site from{sites_[w.corner.vertex].position, sites_[v].metric};
  return corner_angle(from, sites_[w.first_end].position, sites_[w.last_end].position) <
         guard * degrees;
}

std::vector<const domain_wedge*> refine_state::wedges_at_split(vertex_index v) const {
  std::vector<const domain_wedge*> found;
  if (v < split_segment_.size() && split_segment_[v])
    for (const std::size_t i : wedges_of_segment_[*split_segment_[v]]) found.push_back(&wedges_[i]);
  return found;
}

const domain_wedge* refine_state::wedge_across(
    const triangle& t, const std::function<bool(const domain_wedge&)>& accepts) const {
  const auto splits = [this](vertex_index v) {
    return v < split_segment_.size() && split_segment_[v];
  };
  const auto is_on = [&](vertex_index v, vertex_index segment, vertex_index end) {
    return splits(v) ? *split_segment_[v] == segment : v == end;
  };
  const auto one = std::find_if(t.begin(), t.end(), splits);
  if (one == t.end()) return nullptr;
  for (const domain_wedge* w : wedges_at_split(*one)) {
    bool first = false, last = false, elsewhere = false;
    for (const vertex_index v : t) {
      const bool on_first = is_on(v, w->first, w->first_end);
      const bool on_last = is_on(v, w->last, w->last_end);
      first = first || on_first;
      last = last || on_last;
      elsewhere = elsewhere || !(on_first || on_last || v == w->corner.vertex);
    }
    if (first && last && !elsewhere && accepts(*w)) return w;
  }
  return nullptr;
}

// Where the subsegment is as far from the corner of a wedge as the encroacher on its other segment.
std::optional<point> refine_state::mirrored_split_point(const boundary_edge& subsegment,
                                                        vertex_index encroacher) const {
  for (const std::size_t i : wedges_of_segment_[subsegment.segment]) {
    const domain_wedge& w = wedges_[i];
    if (!w.internal || w.corner.angle >= mirrored_angle) continue;
    const bool is_first = subsegment.segment == w.first;
    const bool across = split_segment_.size() > encroacher && split_segment_[encroacher]
                            ? *split_segment_[encroacher] == (is_first ? w.last : w.first)
                            : encroacher == (is_first ? w.last_end : w.first_end);
    if (!across) continue;
    const site& corner = sites_[w.corner.vertex];
    const point *near = &sites_[subsegment.a].position, *far = &sites_[subsegment.b].position;
    double near_distance = distance_from(corner, *near), far_distance = distance_from(corner, *far);
    if (near_distance > far_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (const auto q = point_between(*near, *far, near_distance, far_distance,
                                     distance_from(corner, sites_[encroacher].position)))
      return q;
  }
  return std::nullopt;
}

// Beyond the first subsegment of a segment in a narrow wedge: at round distances from the corner,
// so that both segments of the wedge are split alike. Of two corners the nearer counts.
std::optional<point> refine_state::wedge_split_point(const boundary_edge& subsegment) const {
  const point &a = sites_[subsegment.a].position, &b = sites_[subsegment.b].position;
  const domain_wedge* nearest = nullptr;
  double least = 0;
  for (const std::size_t i : wedges_of_segment_[subsegment.segment]) {
    const domain_wedge& w = wedges_[i];
    if (!w.internal || w.corner.angle >= mirrored_angle) continue;
    const point& c = sites_[w.corner.vertex].position;
    const double far =
        std::abs(a.x - c.x) + std::abs(a.y - c.y) + std::abs(b.x - c.x) + std::abs(b.y - c.y);
    if (nearest == nullptr || far < least) {
      nearest = &w;
      least = far;
    }
  }
  if (nearest == nullptr) return std::nullopt;
  const site& corner = sites_[nearest->corner.vertex];
  const double from_a = distance_from(corner, a), from_b = distance_from(corner, b);
  const bool a_first = from_a < from_b;
  const double low = std::min(from_a, from_b), high = std::max(from_a, from_b);
  if (!(low > 0 && low < high)) return std::nullopt;
  return point_between(a_first ? a : b, a_first ? b : a, low, high, coarsest_in_middle(low, high));
}

}  // namespace asterism::internal
