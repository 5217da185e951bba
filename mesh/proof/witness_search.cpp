// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/witness_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/proof/gap_geometry.hpp"
#include "asterism/mesh/proof/meeting_search.hpp"
#include "asterism/mesh/proof/meeting_witness.hpp"

namespace asterism::internal::proof_detail {
namespace {

using vector = vector2<double>;
using metric = tensor<double>;

// Returns the t at which the point v + aside y + t d is equally far from v and w; for greater t it
// is nearer to w.
double balance(const edge_sites& e, const vector& d, const vector& y, double aside) {
  const metric own(e.v.metric), other(e.w.metric);
  const vector shift = aside * y, back = shift - d;
  const double second = own.square(d) - other.square(d),
               first = 2 * (dot(own * d, shift) - dot(other * d, back)),
               constant = own.square(shift) - other.square(back);
  const double root = std::sqrt(std::max(0.0, first * first - 4 * second * constant));
  return first >= 0 ? -2 * constant / (first + root) : (root - first) / (2 * second);
}

}  // namespace

std::optional<proof_point> find_edge_point(const plane& all, std::uint32_t edge) {
  const edge_sites e = sites_of_edge(all, edge);
  const vector d = from(e.v, e.w), y = from(e.v, e.y), x = from(e.v, e.x);
  // Writes points as v + a d + b y. At the Voronoi vertices on either side of the edge b is `left`
  // and `right`; points of the bisector of v and w with b between these two are farther from x and
  // from y than from v and w.
  const double left = in_basis(voronoi_vertex(e.v, e.w, e.y), d, y).y,
               right = in_basis(voronoi_vertex(e.v, e.x, e.w), d, y).y;
  const double by_x = in_basis(x, d, y).y;
  std::vector<double> aside = {(left + right) / 2, 0};
  for (const double part : {0.25, 0.75, 0.125, 0.875, 0.0625, 0.9375, 0.03125, 0.96875, 0.01, 0.99})
    aside.push_back(left + part * (right - left));
  for (const double part : {0.1, 0.25, 0.5, 1.0}) {
    aside.push_back(part);
    aside.push_back(part * by_x);
  }
  for (const double beside : aside) {
    const double along = balance(e, d, y, beside);
    const auto b = on_grid(beside, -0x1p31), a = on_grid(along, -0x1p31 + 256);
    if (!a || !b) continue;
    const double exact = balance(e, d, y, static_cast<double>(*b) * grid_step);
    const auto near = on_grid(exact, -0x1p31 + 256);
    if (!near) continue;
    const proof_point p = {*near - static_cast<std::int32_t>(window / 2), *b};
    if (decide([&](auto zero) { return is_kept<decltype(zero)>(e, as_grid_point(p)); })) return p;
  }
  return std::nullopt;
}

namespace {

// Returns the coefficients in x and y of the direction to the gap's Voronoi vertex, or of the
// nearer ray if the vertex is not between the rays.
vector towards_vertex(const gap_ends& g) {
  vector part = in_basis(voronoi_vertex(g.v, g.x, g.y), g.to_x, g.to_y);
  part = {std::max(0.0, part.x), std::max(0.0, part.y)};
  return part.x + part.y > 0 && std::isfinite(part.x + part.y) ? part : vector{1, 1};
}

// Returns a gap's witness whose middle point lies in the direction `part`, just beyond both
// bisectors.
std::optional<proof_gap> witness_along(const gap_ends& g, const vector& part, double slack) {
  const auto q = point_along(part, std::min(g.meets_x(part), g.meets_y(part)), slack);
  if (!q) return std::nullopt;
  const vector at =
      g.at({static_cast<double>((*q)[0]) * grid_step, static_cast<double>((*q)[1]) * grid_step});
  const auto on_x = on_grid((1 + slack) * part_of_edge(g.v, g.to_x, g.x, at), 1),
             on_y = on_grid((1 + slack) * part_of_edge(g.v, g.to_y, g.y, at), 1);
  if (!on_x || !on_y) return std::nullopt;
  return proof_gap{*on_x, *q, *on_y};
}

// Number of steps from one ray to the other in which a row of more than three points counts its
// directions: low enough that two points of the grid can lie in one such direction.
constexpr int turns = 256;

vector direction_of_turn(int turn) {
  const double t = static_cast<double>(turn) / turns;
  return {1 - t, t};
}

// Returns the turn of the direction u for which |u| / t is greatest, where t u is the farther of
// the two points at which the ray along u meets the bisectors; none if no such ray meets both.
std::optional<int> common_direction(const gap_ends& g) {
  const metric own(g.v.metric);
  std::optional<int> best;
  double greatest = 0;
  for (int turn = 0; turn <= turns; ++turn) {
    const vector part = direction_of_turn(turn), u = g.at(part);
    if (!(dot(own * g.to_x, u) > 0 && dot(own * g.to_y, u) > 0)) continue;
    const double both = std::min(g.meets_x(part), g.meets_y(part)) * std::sqrt(own.square(u));
    if (!(both > greatest)) continue;
    greatest = both;
    best = turn;
  }
  return best;
}

// Returns the first grid point along direction_of_turn(turn) that is at (1 + slack) / bound times
// this direction or farther.
std::optional<proof_point> point_on_turn(int turn, double bound, double slack) {
  if (!(bound > 0)) return std::nullopt;
  const auto steps = on_grid((1 + slack) / bound / turns, 1);
  if (!steps || *steps > std::numeric_limits<std::int32_t>::max() / turns) return std::nullopt;
  return proof_point{*steps * (turns - turn), *steps * turn};
}

// Returns a row of 2 (each + 1) points. From the ray to x to the common direction they are a factor
// 1 + slack beyond the bisector of v and x, from there to the ray to y as much beyond that of v and
// y.
std::optional<proof_exception> make_row(const gap_ends& g, int turn, std::size_t each,
                                        double slack) {
  const vector middle = direction_of_turn(turn);
  proof_exception row;
  const auto add = [&](const vector& from, const vector& to, std::size_t i, bool of_x) {
    const double t = static_cast<double>(i) / static_cast<double>(each);
    const bool is_middle = i == (of_x ? each : 0);
    const vector part = is_middle ? middle : (1 - t) * from + t * to;
    const double bound = of_x ? g.meets_x(part) : g.meets_y(part);
    const auto p = is_middle ? point_on_turn(turn, bound, slack) : point_along(part, bound, slack);
    if (p) row.points.push_back(*p);
    return p.has_value();
  };
  for (std::size_t i = 0; i <= each; ++i)
    if (!add({1, 0}, middle, i, true)) return std::nullopt;
  row.turn = static_cast<std::uint8_t>(row.points.size());
  for (std::size_t i = 0; i <= each; ++i)
    if (!add(middle, {0, 1}, i, false)) return std::nullopt;
  return row;
}

// Returns the first row for which accept(row) holds, trying rows of more and more points.
template <class Accept>
std::optional<proof_exception> first_row(const gap_ends& g, const Accept& accept) {
  const auto turn = common_direction(g);
  if (!turn) return std::nullopt;
  for (const std::size_t each : {1, 2, 4, 8, 15})
    for (const double slack : {0x1p-22, 0x1p-14, 0x1p-11, 0x1p-9, 0x1p-7, 0x1p-5, 0x1p-3}) {
      auto row = make_row(g, *turn, each, slack);
      if (!row) continue;
      const std::vector<grid_point> points = points_of(*row);
      const gap_row asked{points, row->turn};
      if (is_sound(g.sites(), asked) && accept(asked)) return row;
    }
  return std::nullopt;
}

// Returns a boundary segment that the segment from the gap's centre to w crosses.
std::optional<proof_exception> find_hiding(const plane& all, std::uint32_t gap, vertex_index w) {
  const filtered_kernel kernel;
  const vertex_index v = all.corner(gap);
  const auto side = [&](vertex_index d) {
    return kernel.orientation(all.position(v), all.position(w), all.position(d));
  };
  std::uint32_t edge = plane::next(gap);
  constexpr std::size_t most = 100000;
  for (std::size_t i = 0; i < most; ++i) {
    if (all.is_segment[edge]) {
      proof_exception found;
      found.why = proof_exception::reason::hidden;
      found.points = {{static_cast<std::int32_t>(all.corner(edge)),
                       static_cast<std::int32_t>(all.corner(edge, 1))}};
      return found;
    }
    const std::uint32_t reverse = all.across[edge];
    if (reverse == plane::none) return std::nullopt;
    const vertex_index apex = all.corner(plane::previous(reverse));
    const sign of_apex = apex == w ? sign::zero : side(apex);
    if (of_apex == sign::zero) return std::nullopt;
    // Uses that the segment to w crosses the edge on the right of the apex if the apex is on the
    // segment's left.
    edge = of_apex == sign::positive ? plane::next(reverse) : plane::previous(reverse);
  }
  return std::nullopt;
}

std::optional<proof_exception> find_refusing_meeting(const plane& all, std::uint32_t gap,
                                                     vertex_index w) {
  if (auto found = find_meeting(all, gap, w, true)) return found;
  const std::uint32_t behind = gap_behind(all, gap);
  if (behind != plane::none && all.corner(behind) == w)
    return find_meeting(all, behind, all.corner(gap), true);
  return find_meeting(all, gap, w, true, true);
}

}  // namespace

std::optional<proof_exception> find_edge_meeting(const plane& all, std::uint32_t edge) {
  const std::uint32_t left = plane::previous(edge), right = gap_behind(all, left);
  // Prefers a meeting that also shows that the gap refuses the site opposite.
  for (const bool is_refused : {true, false}) {
    if (auto found = find_meeting(all, left, all.corner(right), is_refused)) return found;
    if (auto found = find_meeting(all, right, all.corner(left), is_refused)) return found;
  }
  return std::nullopt;
}

std::optional<proof_gap> find_row(const gap_sites& sites) {
  const gap_ends g(sites.v, sites.x, sites.y);
  const vector to_vertex = towards_vertex(g);
  for (const vector& part : {to_vertex, vector{1, 1}, vector{1, 0}, vector{0, 1}})
    for (const double slack : {0x1p-24, 0x1p-20, 0x1p-16, 0x1p-12, 0x1p-8, 0x1p-4, 0.5}) {
      const auto row = witness_along(g, part, slack);
      if (!row) continue;
      const std::array<grid_point, 3> points = {
          grid_point{row->on_x, 0}, as_grid_point(row->between), grid_point{0, row->on_y}};
      if (is_sound(sites, {points, 1})) return row;
    }
  return std::nullopt;
}

std::optional<proof_exception> find_wide_row(const gap_sites& sites) {
  return first_row(gap_ends(sites.v, sites.x, sites.y), [](const gap_row&) { return true; });
}

std::optional<proof_exception> find_exception(const plane& all, std::uint32_t gap, vertex_index w) {
  const gap_sites sites = sites_of_gap(all, gap);
  const site& other = all.subject.sites[w];
  std::optional<proof_exception> found = find_hiding(all, gap, w);
  const auto try_row = [&](const gap_ends& g, const site& z, proof_exception::reason why) {
    if (found) return;
    found = first_row(g, [&](const gap_row& row) { return refuses(g.sites(), row, z); });
    if (found) found->why = why;
  };
  try_row(gap_ends(sites.v, sites.x, sites.y), other, proof_exception::reason::by_gap);
  try_row(gap_ends(other, sites.y, sites.x), sites.v, proof_exception::reason::by_site);
  if (!found) return find_refusing_meeting(all, gap, w);
  found->gap = gap;
  found->site = w;
  return found;
}

}  // namespace asterism::internal::proof_detail
