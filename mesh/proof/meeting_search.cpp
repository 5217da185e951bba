// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/meeting_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "asterism/mesh/proof/gap_geometry.hpp"
#include "asterism/mesh/proof/meeting_weights.hpp"
#include "asterism/mesh/proof/meeting_witness.hpp"
#include "asterism/mesh/proof/star_pairs.hpp"

namespace asterism::internal::proof_detail {
namespace {

// The Voronoi vertex of a gap, as displacement from v; and the tangents there to the bisectors of v
// and x, and of v and y, each towards points farther from the other neighbour. Both are as long as
// the displacement, in v's metric.
struct meeting_place {
  offset at, along_x, along_y;
};

std::optional<meeting_place> place_of(const gap_ends& g) {
  const tensor<double> own(g.v.metric), by_x(g.x.metric), by_y(g.y.metric);
  const offset q = voronoi_vertex(g.v, g.x, g.y);
  const offset slope_x = by_x * (q - g.to_x) - own * q, slope_y = by_y * (q - g.to_y) - own * q;
  const auto along = [&](const offset& slope, const offset& other) {
    const offset way{-slope.y, slope.x};
    const double length = std::sqrt(own.square(q) / own.square(way));
    return (dot(way, other) < 0 ? -length : length) * way;
  };
  const meeting_place place{q, along(slope_x, slope_y), along(slope_y, slope_x)};
  const double sum = place.at.x + place.at.y + place.along_x.x + place.along_x.y + place.along_y.x +
                     place.along_y.y;
  if (!std::isfinite(sum)) return std::nullopt;
  return place;
}

std::optional<grid_point> nearest_on_grid(const offset& part) {
  const double a = std::round(part.x / grid_step), b = std::round(part.y / grid_step);
  constexpr double most = 0x1p31 - 256;
  if (!(std::abs(a) < most && std::abs(b) < most)) return std::nullopt;
  return grid_point{static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)};
}

// Returns the box whose corner m lies at distance `beyond` past both bisectors, with sides of
// length `side`. Returns none where the grid cannot represent it.
std::optional<meeting_box> box_at(const gap_ends& g, const meeting_place& p, double side,
                                  double beyond) {
  const auto on_grid_from = [&](const offset& q) {
    return nearest_on_grid(in_basis(q, g.to_x, g.to_y));
  };
  const auto m = on_grid_from(p.at - beyond * (p.along_x + p.along_y)),
             d1 = on_grid_from(side * p.along_x), d2 = on_grid_from(side * p.along_y);
  if (!m || !d1 || !d2) return std::nullopt;
  return meeting_box{{m->a + d1->a, m->b + d1->b}, *m, {m->a + d2->a, m->b + d2->b}};
}

offset part_of(const grid_point& q) {
  return {static_cast<double>(q.a) * grid_step, static_cast<double>(q.b) * grid_step};
}

proof_point as_proof_point(const grid_point& q) {
  return {static_cast<std::int32_t>(q.a), static_cast<std::int32_t>(q.b)};
}

// Returns the points of a row from the ray to x (or y) to a corner of the box, without that corner.
// With `count` 1 it is the point where the bisector's tangent at the corner meets the ray;
// otherwise `count` points just beyond the bisector.
std::optional<std::vector<proof_point>> side_of_row(const gap_ends& g, const grid_point& corner,
                                                    bool of_x, int count, double slack) {
  const offset to = part_of(corner), ray = of_x ? offset{1, 0} : offset{0, 1};
  std::vector<proof_point> points;
  if (count == 1) {
    const double part = (1 + slack) * (of_x ? part_of_edge(g.v, g.to_x, g.x, g.at(to))
                                            : part_of_edge(g.v, g.to_y, g.y, g.at(to)));
    const auto steps = on_grid(part, 1);
    if (!steps) return std::nullopt;
    points.push_back(of_x ? proof_point{*steps, 0} : proof_point{0, *steps});
    return points;
  }
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / count;
    const offset part = (1 - t) * ray + t * (1 / (to.x + to.y)) * to;
    const auto p = point_along(part, of_x ? g.meets_x(part) : g.meets_y(part), slack);
    if (!p) return std::nullopt;
    points.push_back(*p);
  }
  if (!of_x) std::reverse(points.begin(), points.end());
  return points;
}

// Completes a witness by a row that turns in the box and shows that the gap refuses w.
bool add_row(const gap_ends& g, const site& w, const meeting_box& box, proof_exception& found) {
  for (const int count : {1, 2, 4, 8, 14})
    for (const double slack : {0x1p-22, 0x1p-16, 0x1p-12, 0x1p-8, 0x1p-5}) {
      auto first = side_of_row(g, box.c1, true, count, slack);
      const auto last = side_of_row(g, box.c2, false, count, slack);
      if (!first || !last) continue;
      std::vector<proof_point> points = std::move(*first);
      for (const grid_point& q : {box.c1, box.m, box.c2}) points.push_back(as_proof_point(q));
      points.insert(points.end(), last->begin(), last->end());
      proof_exception row = found;
      row.points = std::move(points);
      row.turn = static_cast<std::uint8_t>(count + 1);
      const std::vector<grid_point> at = points_of(row);
      const gap_row asked{at, row.turn};
      if (!is_sound(g.sites(), asked) || !refuses_but_at_turn(g.sites(), asked, w)) continue;
      found = std::move(row);
      return true;
    }
  return false;
}

// Returns a meeting of the gap with w. With `is_refused` the meeting's row also shows that the gap
// refuses w.
std::optional<proof_exception> meeting_of_gap(const gap_ends& g, const site& w, bool is_refused) {
  const auto place = place_of(g);
  if (!place) return std::nullopt;
  for (const double side : {0x1p-10, 0x1p-13, 0x1p-16, 0x1p-18, 0x1p-7})
    for (const double part : {0x1p-4, 0x1p-6, 0x1p-2}) {
      const auto box = box_at(g, *place, side, side * part);
      if (!box) continue;
      auto weights = find_weights({g.v, g.x, g.y, w}, *box);
      if (!weights) continue;
      proof_exception found;
      found.why = proof_exception::reason::meeting;
      found.turn = 1;
      for (const grid_point& q : {box->c1, box->m, box->c2})
        found.points.push_back(as_proof_point(q));
      found.weights = std::move(*weights);
      if (add_row(g, w, *box, found) || !is_refused) return found;
    }
  return std::nullopt;
}

}  // namespace

std::optional<proof_exception> find_meeting(const plane& all, std::uint32_t gap, vertex_index w,
                                            bool is_refused, bool is_by_site) {
  const gap_sites s = sites_of_gap(all, gap);
  const site& other = all.subject.sites[w];
  auto found = is_by_site ? meeting_of_gap(gap_ends(other, s.y, s.x), s.v, is_refused)
                          : meeting_of_gap(gap_ends(s.v, s.x, s.y), other, is_refused);
  if (!found) return std::nullopt;
  found->gap = gap;
  found->site = w;
  if (is_by_site) found->turn = static_cast<std::uint8_t>(found->turn + turn_by_site);
  return found;
}

}  // namespace asterism::internal::proof_detail
