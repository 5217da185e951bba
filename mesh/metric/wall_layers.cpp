// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/wall_layers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "asterism/mesh/domain/smooth_vertices.hpp"

namespace asterism::internal {
namespace {

constexpr double most_turn = 0.16, chord_of_curvature = 0.4;  // the header derives them
constexpr double growth_along = usual_growth - 1;

double length(const point& u) { return std::sqrt(u.x * u.x + u.y * u.y); }

point direction(const point& from, const point& to) {
  const point u{to.x - from.x, to.y - from.y};
  const double l = length(u);
  return l > 0 ? point{u.x / l, u.y / l} : point{0, 0};
}

double cross(const point& u, const point& w) { return u.x * w.y - u.y * w.x; }
double dot(const point& u, const point& w) { return u.x * w.x + u.y * w.y; }

// Returns a number that grows with the angle of a unit vector, from 0 to 4 all around.
double place_around(const point& u) {
  const double part = std::abs(u.y) / (std::abs(u.x) + std::abs(u.y));
  if (u.y >= 0) return u.x >= 0 ? part : 2 - part;
  return u.x < 0 ? 2 + part : 4 - part;
}

constexpr std::size_t no_side = static_cast<std::size_t>(-1);

// A segment at a vertex: its direction away from it, and its wall.
struct spoke {
  point direction;  // away from the vertex
  double length = 0;
  double place = 0;
  std::size_t leaving = no_side, arriving = no_side;         // wall sides
  bool has_domain_before = false, has_domain_after = false;  // clockwise, counter-clockwise of it
};

// Lists the spokes of all vertices that walls touch.
std::vector<std::vector<spoke>> spokes_of(const domain& d, const std::vector<wall_side>& sides) {
  std::vector<char> is_on_wall(d.vertices.size(), 0);
  std::vector<std::size_t> forward(d.segments.size(), no_side), backward = forward;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const wall_side& side = sides[i];
    is_on_wall[side.a] = is_on_wall[side.b] = 1;
    (side.a == d.segments[side.segment].a ? forward : backward)[side.segment] = i;
  }
  std::vector<std::vector<spoke>> all(d.vertices.size());
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    const auto add = [&](vertex_index from, vertex_index to, bool is_start) {
      if (is_on_wall[from] == 0) return;
      spoke made;
      made.direction = direction(d.vertices[from], d.vertices[to]);
      made.length =
          length({d.vertices[to].x - d.vertices[from].x, d.vertices[to].y - d.vertices[from].y});
      made.place = place_around(made.direction);
      made.leaving = is_start ? forward[s] : backward[s];
      made.arriving = is_start ? backward[s] : forward[s];
      made.has_domain_after = is_start || one.internal;
      made.has_domain_before = !is_start || one.internal;
      all[from].push_back(made);
    };
    add(one.a, one.b, true);
    add(one.b, one.a, false);
  }
  for (auto& around : all)
    std::sort(around.begin(), around.end(),
              [](const spoke& a, const spoke& b) { return a.place < b.place; });
  return all;
}

// The wall at one corner of the domain: the angle between the side that leaves the vertex and the
// one that arrives there, counter-clockwise.
struct wall_corner {
  bool is_smooth = false;  // two sides that are nearly straight on
  double radius = 0;       // of curvature, where it is smooth
  double turn = 0;         // radians, about; of no meaning at the end of a wall that needs nothing
  point normal{0, 0};      // mean of the two, where it is smooth
};

wall_corner corner_between(const spoke& leaving, const spoke& arriving) {
  // Length of the difference of two unit vectors at 30 degrees, from which a turn is sharp.
  constexpr double sharp = 0.5176380902050415;
  // Cosine of 100 degrees: in a corner below that angle a layer ends at a wall, without
  // limits.
  constexpr double across = -0.17364817766693033;
  wall_corner made;
  const point onward{-arriving.direction.x, -arriving.direction.y};
  const point turn{leaving.direction.x - onward.x, leaving.direction.y - onward.y};
  const bool both = leaving.leaving != no_side && arriving.arriving != no_side;
  made.turn = both ? length(turn) : 1;
  made.is_smooth = both && made.turn < sharp;
  if (made.is_smooth) {
    const point mean{leaving.direction.x + onward.x, leaving.direction.y + onward.y};
    const double l = length(mean);
    made.normal = {-mean.y / l, mean.x / l};
    made.radius = (leaving.length + arriving.length) / 2 / made.turn;
    return made;
  }
  const bool is_narrow = cross(leaving.direction, arriving.direction) > 0 &&
                         dot(leaving.direction, arriving.direction) > across;
  if (!both && is_narrow) made.turn = 0;
  return made;
}

// Bent walls: the radius of curvature of each side, and the normals at its ends.
struct bent_walls {
  std::vector<double> radius;
  std::vector<char> is_curved;  // of a curve that was divided
  std::vector<point> normals;   // two of each side
  struct turn {
    vertex_index at;
    std::size_t wish;  // of a side there
    double angle;
  };
  std::vector<turn> turns;
};

point normal_of(const domain& d, const wall_side& side) {
  const point along = direction(d.vertices[side.a], d.vertices[side.b]);
  return {-along.y, along.x};
}

// Takes only the radius where the vertex divides a curve: the angle there comes from the division.
void note_corner(const wall_corner& corner, const spoke& leaving, const spoke& arriving,
                 vertex_index v, bool divides_curve, const std::vector<wall_side>& sides,
                 bent_walls& made) {
  for (const std::size_t side : {leaving.leaving, arriving.arriving}) {
    if (side == no_side) continue;
    if (corner.turn > 0 && !divides_curve) made.turns.push_back({v, sides[side].wish, corner.turn});
    if (divides_curve) made.is_curved[side] = 1;
    if (!corner.is_smooth) continue;
    made.radius[side] = std::min(made.radius[side], corner.radius);
    made.normals[2 * side + (side == leaving.leaving ? 0 : 1)] = corner.normal;
  }
}

bent_walls bend(const domain& d, const std::vector<wall_side>& sides) {
  bent_walls made;
  made.radius.assign(sides.size(), std::numeric_limits<double>::infinity());
  for (const wall_side& side : sides)
    made.normals.insert(made.normals.end(), 2, normal_of(d, side));
  made.is_curved.assign(sides.size(), 0);
  std::vector<char> divides_curve(d.vertices.size(), 0);
  for (const vertex_index v : smooth_vertices(d)) divides_curve[v] = 1;
  const auto around = spokes_of(d, sides);
  for (vertex_index v = 0; v < around.size(); ++v)
    for (std::size_t i = 0; i < around[v].size(); ++i) {
      const spoke& leaving = around[v][i];
      const spoke& arriving = around[v][(i + 1) % around[v].size()];
      if (!leaving.has_domain_after || !arriving.has_domain_before) continue;
      if (leaving.leaving == no_side && arriving.arriving == no_side) continue;
      note_corner(corner_between(leaving, arriving), leaving, arriving, v, divides_curve[v] != 0,
                  sides, made);
    }
  return made;
}

// Returns the places that limit the length of edges along the walls.
std::vector<sized_place> lengths_along(const domain& d, const std::vector<wall_side>& sides,
                                       const bent_walls& bent,
                                       const std::vector<boundary_layers>& layers) {
  std::vector<sized_place> places;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const point &a = d.vertices[sides[i].a], &b = d.vertices[sides[i].b];
    const double across = edge_across(layers[sides[i].wish], 0);
    const double longest = chord_of_curvature * std::sqrt(bent.radius[i] * across);
    if (!std::isfinite(longest)) continue;
    if (bent.is_curved[i] != 0 || length({b.x - a.x, b.y - a.y}) < longest)
      places.push_back({a, b, 0, false, std::max(across, longest), growth_along});
  }
  for (const bent_walls::turn& t : bent.turns) {
    const double across = edge_across(layers[t.wish], 0);
    places.push_back({d.vertices[t.at], d.vertices[t.at], 0, false,
                      std::max(across, most_turn * across / t.angle), growth_along});
  }
  return places;
}

// Returns u^T M u.
double squared(const metric_tensor& m, const point& u) {
  return m.m11 * (u.x * u.x) + 2 * (m.m12 * (u.x * u.y)) + m.m22 * (u.y * u.y);
}

// Makes the displacement of length `longest` along the unit vector `u` at least 1 long in the
// metric: the tensor grows by a multiple of u u^T, so that lengths across u stay.
void shorten(metric_tensor& m, const point& u, double longest) {
  const double lacking = 1 / (longest * longest) - squared(m, u);
  if (!(lacking > 0)) return;
  m.m11 += lacking * (u.x * u.x);
  m.m12 += lacking * (u.x * u.y);
  m.m22 += lacking * (u.y * u.y);
}

}  // namespace

std::vector<wall_side> wall_sides(const domain& d, const std::vector<boundary_layers>& layers) {
  std::vector<wall_side> sides;
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    for (std::size_t w = 0; w < layers.size(); ++w) {
      if (layers[w].marker != one.marker) continue;
      sides.push_back({one.a, one.b, s, w});
      if (one.internal) sides.push_back({one.b, one.a, s, w});
      break;
    }
  }
  return sides;
}

double edge_across(const boundary_layers& layers, double distance) {
  constexpr double edge_of_height = 2 / std::numbers::sqrt3;
  double height = layers.first_height + (layers.growth - 1) * distance;
  if (layers.layers && layers.growth < usual_growth) {
    // Finds the height after the last layer, and the distance at which it ends.
    double last = layers.first_height, end = 0;
    for (int i = 0; i < *layers.layers && end <= distance; ++i) {
      end += last;
      last *= layers.growth;
    }
    if (end < distance) height = last + (usual_growth - 1) * (distance - end);
  }
  return edge_of_height * height;
}

wall_layers::wall_layers(const domain& d, std::vector<boundary_layers> layers)
    : layers_(std::move(layers)), lengths_along_({}), found_(layers_.size(), false) {
  const std::vector<wall_side> sides = wall_sides(d, layers_);
  const bent_walls bent = bend(d, sides);
  lengths_along_ = place_tree(lengths_along(d, sides, bent, layers_));
  std::vector<std::vector<sized_place>> places(layers_.size());
  std::vector<std::vector<point>> normals(layers_.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::size_t w = sides[i].wish;
    found_[w] = true;
    places[w].push_back({d.vertices[sides[i].a], d.vertices[sides[i].b]});
    normals[w].push_back(bent.normals[2 * i]);
    normals[w].push_back(bent.normals[2 * i + 1]);
  }
  for (std::size_t w = 0; w < layers_.size(); ++w)
    walls_.push_back({place_tree(std::move(places[w])), std::move(normals[w])});
}

// Returns the direction from the nearest point of the segment to q. This is the segment's normal if
// that point is between its ends; at an end itself it is the normal of the wall there.
point wall_layers::direction_across(const one_wall& wall, const point& q,
                                    std::size_t segment) const {
  const sized_place& s = wall.segments.places()[segment];
  const point foot = nearest_on_segment(q, s.a, s.b);
  if (q == s.a) return wall.normals_at_ends[2 * segment];
  if (q == s.b) return wall.normals_at_ends[2 * segment + 1];
  if (foot == s.a || foot == s.b) return direction(foot, q);
  const point along = direction(s.a, s.b);
  return {-along.y, along.x};
}

metric_tensor wall_layers::added_to(const metric_tensor& m, const point& q) const {
  metric_tensor made = m;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const place_tree::found nearest = walls_[w].segments.least_at(q);
    if (walls_[w].segments.places().empty()) continue;
    const point across = direction_across(walls_[w], q, nearest.place);
    shorten(made, across, edge_across(layers_[w], nearest.size));
    const double along = lengths_along_.least_at(q).size;
    if (std::isfinite(along)) shorten(made, {-across.y, across.x}, along);
  }
  return made;
}

}  // namespace asterism::internal
