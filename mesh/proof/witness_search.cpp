// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/witness_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal::proof_detail {
namespace {

using vector = vector2<double>;
using metric = tensor<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

vector from(const site& v, const site& z) {
  return {z.position.x - v.position.x, z.position.y - v.position.y};
}

// Returns the coefficients of p in the basis of x and y.
vector in_basis(const vector& p, const vector& x, const vector& y) {
  const double area = cross(x, y);
  return {cross(p, y) / area, cross(x, p) / area};
}

// Returns the centre, from v, of the circle that the sum of three metrics sees through the sites,
// brought nearer to where all three are equally far.
vector voronoi_vertex(const site& v, const site& x, const site& y) {
  const vector to_x = from(v, x), to_y = from(v, y);
  const metric own(v.metric), by_x(x.metric), by_y(y.metric);
  metric sum = own;
  sum.m11 += by_x.m11 + by_y.m11;
  sum.m12 += by_x.m12 + by_y.m12;
  sum.m22 += by_x.m22 + by_y.m22;
  const auto solve = [](const vector& a, const vector& b, double of_a, double of_b) {
    const double inverse = 1 / cross(a, b);
    return vector{inverse * (of_a * b.y - of_b * a.y), inverse * (of_b * a.x - of_a * b.x)};
  };
  vector u = solve(sum * to_x, sum * to_y, sum.square(to_x) / 2, sum.square(to_y) / 2);
  constexpr int steps = 6;
  for (int i = 0; i < steps; ++i) {
    const vector from_x = u - to_x, from_y = u - to_y;
    const vector slope_x = by_x * from_x - own * u, slope_y = by_y * from_y - own * u;
    const double square = own.square(u);
    const vector step = solve(slope_x, slope_y, (square - by_x.square(from_x)) / 2,
                              (square - by_y.square(from_y)) / 2);
    const vector nearer = u + step;
    if (!(std::abs(nearer.x) + std::abs(nearer.y) < infinity)) break;
    u = nearer;
  }
  return u;
}

// Returns an integer of the grid from `least` on; none for what does not fit into the format.
std::optional<std::int32_t> on_grid(double part, double least) {
  const double steps = std::ceil(part / grid_step);
  if (!(steps >= least && steps <= 0x1p31 - 256)) return std::nullopt;
  return static_cast<std::int32_t>(steps);
}

// Where on the line at `aside` of y, in the direction of d from v, v and w are equally far; and w
// is nearer beyond.
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
  // Between these two, on both sides of the edge, both neighbours are farther.
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

// Returns 1 over the part of the ray along u up to the first point as near to z as to v; negative
// where there is none.
double meeting(const site& v, const vector& z, const site& at, const vector& u) {
  const metric own(v.metric), other(at.metric);
  const double c = other.square(z), along = dot(u, other * z),
               radicand = along * along + c * (own.square(u) - other.square(u));
  return radicand >= 0 ? (along + std::sqrt(radicand)) / c : -1;
}

struct gap_ends {
  const site &v, &x, &y;
  vector to_x, to_y;

  gap_ends(const site& centre, const site& first, const site& last)
      : v(centre), x(first), y(last), to_x(from(v, x)), to_y(from(v, y)) {}
  vector at(const vector& part) const { return part.x * to_x + part.y * to_y; }
  double meets_x(const vector& part) const { return meeting(v, to_x, x, at(part)); }
  double meets_y(const vector& part) const { return meeting(v, to_y, y, at(part)); }
};

// Returns the direction of the gap's Voronoi vertex, or the ray that it is beyond, as parts of x
// and y.
vector towards_vertex(const gap_ends& g) {
  vector part = in_basis(voronoi_vertex(g.v, g.x, g.y), g.to_x, g.to_y);
  part = {std::max(0.0, part.x), std::max(0.0, part.y)};
  return part.x + part.y > 0 && part.x + part.y < infinity ? part : vector{1, 1};
}

gap_ends ends_of(const plane& all, std::uint32_t gap) {
  const auto at = [&](std::uint32_t i) -> const site& {
    return all.subject.sites[all.corner(gap, i)];
  };
  return {at(0), at(1), at(2)};
}

// Returns the point of the grid that is so far along this direction, and a little farther.
std::optional<proof_point> point_along(const vector& part, double bound, double slack) {
  if (!(bound > 0)) return std::nullopt;
  const double far = (1 + slack) / bound;
  const auto a = on_grid(part.x * far, 0), b = on_grid(part.y * far, 0);
  if (!a || !b) return std::nullopt;
  return proof_point{*a, *b};
}

// Returns from where on the ray to z the segment to q is nowhere nearer to v than to z: from where
// the ray meets the bisector, and the tangent at q.
double part_of_edge(const site& v, const vector& z, const site& at, const vector& q) {
  const metric own(v.metric), other(at.metric);
  const double first = 1 / meeting(v, z, at, z);
  // The product of both differences is slope t + constant at t z.
  const double constant = dot(other * z, q - z), slope = dot(own * z, q) - constant;
  const double tangent = -constant / slope;
  return slope > 0 && tangent > first ? tangent : first;
}

// Returns a gap's witness with its middle point in this direction, just beyond both bisectors.
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

// Returns directions between two, from the first on.
std::vector<vector> directions_between(const vector& first, const vector& last, std::size_t each) {
  std::vector<vector> parts;
  for (std::size_t i = 0; i < each; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(each);
    parts.push_back((1 - t) * first + t * last);
  }
  return parts;
}

// Returns a fan around the gap that shows it to refuse w: points a little beyond the bisector of x
// up to the direction of the vertex, and of y from there on.
std::optional<proof_exception> find_fan(const gap_ends& g, const site& w, std::size_t each,
                                        double slack) {
  const vector middle = towards_vertex(g);
  std::vector<vector> parts = directions_between({1, 0}, middle, each);
  const std::vector<vector> rest = directions_between(middle, {0, 1}, each);
  parts.insert(parts.end(), rest.begin(), rest.end());
  parts.push_back({0, 1});
  proof_exception found;
  found.turn = static_cast<std::uint8_t>(each);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double of_x = g.meets_x(parts[i]), of_y = g.meets_y(parts[i]);
    const double bound = i < each ? of_x : i > each ? of_y : std::min(of_x, of_y);
    const auto p = point_along(parts[i], bound, i == each ? 0x1p-24 : slack);
    if (!p) return std::nullopt;
    found.points.push_back(*p);
  }
  if (is_refused_by(g.v, g.x, g.y, w, found.points, found.turn)) return found;
  return std::nullopt;
}

// Returns a segment that the way from the gap's centre to w crosses.
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
    // The way goes between the end of the edge on its right, which reverse arrives at, and y.
    edge = of_apex == sign::positive ? plane::next(reverse) : plane::previous(reverse);
  }
  return std::nullopt;
}

}  // namespace

std::optional<proof_gap> find_gap_witness(const plane& all, std::uint32_t gap) {
  const gap_ends g = ends_of(all, gap);
  const vector to_vertex = towards_vertex(g);
  for (const vector& part : {to_vertex, vector{1, 1}, vector{1, 0}, vector{0, 1}})
    for (const double slack : {0x1p-24, 0x1p-20, 0x1p-16, 0x1p-12, 0x1p-8, 0x1p-4, 0.5}) {
      const auto witness = witness_along(g, part, slack);
      if (witness && is_gap_sound(all, gap, *witness)) return witness;
    }
  return std::nullopt;
}

std::optional<proof_exception> find_exception(const plane& all, std::uint32_t gap, vertex_index w) {
  const gap_ends g = ends_of(all, gap);
  const site& other = all.subject.sites[w];
  std::optional<proof_exception> found = find_hiding(all, gap, w);
  for (const std::size_t each : {2, 4, 8})
    for (const double slack : {0x1p-20, 0x1p-12, 0x1p-9, 0x1p-7, 0x1p-5, 0x1p-3}) {
      if (found) break;
      found = find_fan(g, other, each, slack);
      if (found) break;
      found = find_fan(gap_ends(other, g.y, g.x), g.v, each, slack);
      if (found) found->why = proof_exception::reason::by_site;
    }
  if (!found) return std::nullopt;
  found->gap = gap;
  found->site = w;
  return found;
}

}  // namespace asterism::internal::proof_detail
