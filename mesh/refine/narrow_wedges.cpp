// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/narrow_wedges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism::internal {
namespace {

// True if the segments of a wedge are to be split at equal distances from its corner. Wider wedges,
// and those without an internal segment, have room for sites that mend their triangles.
bool is_mirrored_in(const domain_wedge& w) {
  constexpr double mirrored_angle = 10;
  return w.internal && w.corner.angle < mirrored_angle;
}

double distance_from(const site& corner, const point& q) {
  return std::sqrt(squared_distance(corner, q));
}

// Returns the point between `near` and `far`, two points in line with a corner at the distances
// given, that is at the distance `wanted` from the corner. None unless it is strictly between them.
std::optional<point> point_between(const point& near, const point& far, double near_distance,
                                   double far_distance, double wanted) {
  if (!(near_distance < wanted && wanted < far_distance)) return std::nullopt;
  const double part = (wanted - near_distance) / (far_distance - near_distance);
  const double x = near.x + part * (far.x - near.x), y = near.y + part * (far.y - near.y);
  return point{std::clamp(x, std::min(near.x, far.x), std::max(near.x, far.x)),
               std::clamp(y, std::min(near.y, far.y), std::max(near.y, far.y))};
}

// Returns the multiple of a power of two in the middle half of [low, high] for the greatest power
// that has a multiple there; of several multiples the nearest to the middle. Requires 0 < low <
// high.
double coarsest_in_middle(double low, double high) {
  const double quarter = (high - low) / 4, middle = low + 2 * quarter;
  // Finds a multiple at the latest when `step` is no greater than the length of the middle half.
  double step = elementary::exp2(std::ceil(elementary::log2(high)));
  for (int i = 0; i < 64; ++i, step /= 2) {
    const double multiple = step * std::round(middle / step);
    if (std::abs(multiple - middle) <= quarter) return multiple;
  }
  return middle;
}

}  // namespace

narrow_wedges::narrow_wedges(const boundary& edges) {
  for (const boundary_edge& p : edges.subsegments()) {
    if (segments_.size() <= p.segment) segments_.resize(p.segment + 1);
    segments_[p.segment] = {p.a, p.b, p.internal};
  }
  wedges_of_segment_.resize(segments_.size());
}

void narrow_wedges::add(const domain_corner& c, const boundary_edge& leaving,
                        const boundary_edge& entering) {
  domain_wedge w{c, leaving.segment, entering.segment};
  const segment_ends &first = segments_[w.first], &last = segments_[w.last];
  w.first_end = first.a == c.vertex ? first.b : first.a;
  w.last_end = last.a == c.vertex ? last.b : last.a;
  w.internal = first.internal || last.internal;
  wedges_of_segment_[w.first].push_back(wedges_.size());
  wedges_of_segment_[w.last].push_back(wedges_.size());
  wedges_.push_back(w);
}

void narrow_wedges::note_split(vertex_index v, vertex_index segment) {
  if (split_segment_.size() <= v) split_segment_.resize(v + 1);
  split_segment_[v] = segment;
}

bool is_narrower(const std::vector<site>& sites, const domain_wedge& w, vertex_index v,
                 double degrees) {
  constexpr double guard = 1 - 1e-9;
  const site from{sites[w.corner.vertex].position, sites[v].metric};
  return corner_angle(from, sites[w.first_end].position, sites[w.last_end].position) <
         guard * degrees;
}

std::vector<const domain_wedge*> narrow_wedges::at_split(vertex_index v) const {
  std::vector<const domain_wedge*> found;
  if (is_split(v))
    for (const std::size_t i : wedges_of_segment_[*split_segment_[v]]) found.push_back(&wedges_[i]);
  return found;
}

const domain_wedge* narrow_wedges::across(
    const triangle& t, const std::function<bool(const domain_wedge&)>& accepts) const {
  const auto splits = [this](vertex_index v) { return is_split(v); };
  const auto is_on = [&](vertex_index v, vertex_index segment, vertex_index end) {
    return splits(v) ? *split_segment_[v] == segment : v == end;
  };
  const auto one = std::find_if(t.begin(), t.end(), splits);
  if (one == t.end()) return nullptr;
  for (const domain_wedge* w : at_split(*one)) {
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

bool narrow_wedges::is_mirrored(vertex_index segment) const {
  const std::vector<std::size_t>& its = wedges_of_segment_[segment];
  return std::any_of(its.begin(), its.end(),
                     [this](std::size_t i) { return is_mirrored_in(wedges_[i]); });
}

std::optional<point> narrow_wedges::mirrored_point(const std::vector<site>& sites,
                                                   const boundary_edge& subsegment,
                                                   vertex_index encroacher) const {
  for (const std::size_t i : wedges_of_segment_[subsegment.segment]) {
    const domain_wedge& w = wedges_[i];
    if (!is_mirrored_in(w)) continue;
    const bool is_first = subsegment.segment == w.first;
    const bool across = is_split(encroacher)
                            ? *split_segment_[encroacher] == (is_first ? w.last : w.first)
                            : encroacher == (is_first ? w.last_end : w.first_end);
    if (!across) continue;
    const site& corner = sites[w.corner.vertex];
    const point *near = &sites[subsegment.a].position, *far = &sites[subsegment.b].position;
    double near_distance = distance_from(corner, *near), far_distance = distance_from(corner, *far);
    if (near_distance > far_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (const auto q = point_between(*near, *far, near_distance, far_distance,
                                     distance_from(corner, sites[encroacher].position)))
      return q;
  }
  return std::nullopt;
}

std::optional<point> narrow_wedges::split_point(const std::vector<site>& sites,
                                                const boundary_edge& subsegment) const {
  const point &a = sites[subsegment.a].position, &b = sites[subsegment.b].position;
  const domain_wedge* nearest = nullptr;
  double least = 0;
  for (const std::size_t i : wedges_of_segment_[subsegment.segment]) {
    const domain_wedge& w = wedges_[i];
    if (!is_mirrored_in(w)) continue;
    const point& c = sites[w.corner.vertex].position;
    const double far =
        std::abs(a.x - c.x) + std::abs(a.y - c.y) + std::abs(b.x - c.x) + std::abs(b.y - c.y);
    if (nearest == nullptr || far < least) {
      nearest = &w;
      least = far;
    }
  }
  if (nearest == nullptr) return std::nullopt;
  const site& corner = sites[nearest->corner.vertex];
  const double from_a = distance_from(corner, a), from_b = distance_from(corner, b);
  const bool a_first = from_a < from_b;
  const double low = std::min(from_a, from_b), high = std::max(from_a, from_b);
  if (!(low > 0 && low < high)) return std::nullopt;
  return point_between(a_first ? a : b, a_first ? b : a, low, high, coarsest_in_middle(low, high));
}

}  // namespace asterism::internal
