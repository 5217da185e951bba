// SPDX-License-Identifier: MIT
//
// Makes scenes on the border between two answers, in small integers, so that they are exactly
// there; and scenes moved off the border by as little as doubles allow.
#include <array>
#include <utility>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/challenge/scene_parts.hpp"

namespace asterism::challenge {
namespace {

// A linear map of determinant 1 with integer entries, and an integer translation.
struct integer_map {
  double k, l;
  point shift;

  point operator()(const point& p) const {
    const double x = p.x + k * p.y, y = p.y + l * x;
    return {x + shift.x, y + shift.y};
  }
  // Maps a metric so that distances between images equal those between originals: m' = A^-T m A^-1.
  metric_tensor operator()(const metric_tensor& m) const {
    const metric_tensor s = {m.m11, m.m12 - k * m.m11, m.m22 - 2 * k * m.m12 + k * k * m.m11};
    return {s.m11 - 2 * l * s.m12 + l * l * s.m22, s.m12 - l * s.m22, s.m22};
  }
};

// Hides a construction made in convenient coordinates by a linear map. Exact for numbers of few
// digits.
scene moved(scene s, random_source& random) {
  const double k = small_integer(random, 2), l = small_integer(random, 1);
  const integer_map map = {k, l, integer_point(random, 3)};
  for (site& of : s.sites) of = {map(of.position), map(of.metric)};
  s.at = map(s.at);
  return s;
}

// Makes a site at squared distance beta from the origin, at an offset with a coordinate that is 1
// or -1.
site at_distance_from_origin(double beta, random_source& random) {
  const double x = random.chance(2) ? 1 : -1, y = small_integer(random, 3);
  const double m12 = small_integer(random, 4), m22 = random.integer(1, 5);
  const double m11 = beta - 2 * m12 * x * y - m22 * y * y;
  return random.chance(2) ? site{{x, y}, {m11, m12, m22}} : site{{y, x}, {m22, m12, m11}};
}

// Makes a tangency: the bisector of v = (0,0) with tensor (1,0,3) and w = (3,0) with (4,0,12) is
// the ellipse (x-4)^2 + 3 y^2 = 4. The ray from v through (3,1) touches it there: before, at and
// beyond the touching point neither site dominates, or v does. x and y are anywhere.
scene touching_ray(random_source& random) {
  const double t = random.integer(1, 6), side = random.chance(2) ? 1 : -1;
  scene s;
  s.sites[0] = {{0, 0}, {1, 0, 3}};
  s.sites[1] = {{3, 0}, {4, 0, 12}};
  s.at = {0.75 * t, 0.25 * t * side};
  for (std::size_t i = 2; i < 4; ++i)
    s.sites[i] = {integer_point(random, 4), integer_metric(random, 4)};
  return s;
}

// Makes a tangency: the ray from v to the origin, which is equally far from all four, touches the
// bisector of v and w there: at the origin the gradients of f_v - f_w and the ray are at right
// angles.
scene touching_at_common_point(random_source& random) {
  const double a = random.integer(1, 3), beta = random.integer(3, 40);
  const double m11 = random.integer(1, 5), m12 = small_integer(random, 4);
  scene s = common_roots(random);
  for (std::size_t i = 2; i < 4; ++i) s.sites[i] = at_distance_from_origin(beta, random);
  s.sites[0] = {{-a, -1}, {m11, m12, beta - m11 * a * a - 2 * m12 * a}};
  s.sites[1] = {{0, -1}, {double(random.integer(1, 6)), 0, beta}};
  s.at = {0, 0};
  return s;
}

// Makes a cell of w that touches the edge ab: a and b are mirror images of each other, the origin
// is the middle of ab, and w is as far from the origin as a and b. On ab, which is Y = 0, f_w - f_a
// then has a double root, or nearly one, at the origin, where f_a = f_b.
scene touching_edge(random_source& random) {
  const double m11 = random.integer(1, 4), m22 = random.integer(1, 4), h = random.integer(1, 4);
  scene s;
  s.sites[0] = {{-h, 0}, {m11, 0, m22}};
  s.sites[1] = {{h, 0}, {m11, 0, m22}};
  const double up = random.chance(2) ? 1 : -1;
  s.sites[2] = {{0, up}, {double(random.integer(1, 9)), 0, m11 * h * h}};
  s.sites[3] = {{0, -2 * up}, {double(random.integer(1, 9)), 0, m11 * h * h / 4}};
  s.at = {0, 0};
  return s;
}

// Moves a zero, which has no neighbour at a relative distance, to 2^-53 or its opposite.
double barely_moved(double number, random_source& random) {
  if (number != 0) return neighbour(number, random);
  return random.chance(2) ? 0x1p-53 : -0x1p-53;
}

}  // namespace

scene grid(random_source& random) {
  const metric_tensor shared = integer_metric(random, 3);
  const bool equal = random.chance(2);
  scene s = each(random, [&] {
    const point p = integer_point(random, 2);
    return site{p, equal ? shared : integer_metric(random, 3)};
  });
  const double m11 = small_integer(random, 3), m12 = small_integer(random, 3);
  s.tensor = {m11, m12, small_integer(random, 3)};
  return s;
}

// Draws from twelve points of one circle, with one metric: the in-circle test gives zero.
scene cocircular(random_source& random) {
  constexpr std::array<std::array<int, 2>, 3> legs = {{{5, 0}, {3, 4}, {4, 3}}};
  const double scale = random.integer(1, 3);
  scene s = each(random, [&] {
    const auto [a, b] = legs[static_cast<std::size_t>(random.integer(0, 2))];
    const double x = random.chance(2) ? a : -a, y = random.chance(2) ? b : -b;
    const bool exchange = random.chance(2);
    return site{{exchange ? y : x, exchange ? x : y}, {scale, 0, scale}};
  });
  // Leaves half of the scenes unmapped, so that they are cocircular in the plane, too: a map would
  // make an ellipse of the circle.
  return random.chance(2) ? s : moved(s, random);
}

// Places sites, and a point, on one line.
scene collinear(random_source& random) {
  const point start = integer_point(random, 3), step = integer_point(random, 2);
  return each(random, [&] {
    const double k = small_integer(random, 4);
    return site{{start.x + k * step.x, start.y + k * step.y}, integer_metric(random, 4)};
  });
}

scene tangent(random_source& random) {
  constexpr std::array constructions = {touching_ray, touching_at_common_point, touching_edge};
  scene s = constructions[static_cast<std::size_t>(random.integer(0, 2))](random);
  const double a = small_integer(random, 3), b = small_integer(random, 3);
  s.tensor = {a * a, a * b, b * b};  // semidefinite: its unit ellipse has a double root at infinity
  return moved(s, random);
}

// Places all sites at squared distance beta from the origin: the bisectors meet there.
scene common_roots(random_source& random) {
  const double beta = random.integer(2, 30);
  scene s = each(random, [&] { return at_distance_from_origin(beta, random); });
  s.at = {0, 0};
  return random.chance(2) ? s : moved(s, random);
}

// Makes v and w images of each other in the line Y = 0, on which everything else is.
scene mirror_images(random_source& random) {
  scene s = grid(random);
  const site& v = s.sites[0];
  s.sites[1] = {{v.position.x, -v.position.y}, {v.metric.m11, -v.metric.m12, v.metric.m22}};
  for (std::size_t k = 2; k < 4; ++k) {
    s.sites[k].position.y = 0;
    s.sites[k].metric.m12 = 0;
  }
  s.at.y = 0;
  return s;
}

scene degenerate(random_source& random) {
  constexpr std::array constructions = {cocircular, common_roots, collinear, mirror_images,
                                        tangent};
  scene s = constructions[static_cast<std::size_t>(random.integer(0, 4))](random);
  const double a = small_integer(random, 3), b = small_integer(random, 3);
  s.tensor = {a * a, a * b, b * b};  // semidefinite
  return s;
}

scene one_ulp(random_source& random) {
  scene s = degenerate(random);
  site& of = s.sites[static_cast<std::size_t>(random.integer(0, 3))];
  const std::array<double*, 5> numbers = {&of.position.x, &of.position.y, &of.metric.m11,
                                          &of.metric.m12, &of.metric.m22};
  double& number = *numbers[static_cast<std::size_t>(random.integer(0, 4))];
  number = barely_moved(number, random);
  if (random.chance(3)) s.at.x = barely_moved(s.at.x, random);
  s.tensor.m12 = barely_moved(s.tensor.m12, random);
  return s;
}

// Takes the points of Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness
// problems" (2008).
scene kettner(random_source& random) {
  constexpr double unit = 0x1p-53;
  const auto near = [&](double x) {
    const double moved_x = x + unit * random.integer(0, 255);
    return point{moved_x, x + unit * random.integer(0, 255)};
  };
  const metric_tensor m = random.chance(2) ? metric_tensor{1, 0, 1} : integer_metric(random, 3);
  scene s;
  s.sites = {site{near(0.5), m}, site{{12, 12}, m}, site{near(0.5), m}, site{{24, 24}, m}};
  if (random.chance(2)) s.sites[3].position = near(12);
  if (random.chance(3)) s.sites[2].metric.m22 = neighbour(m.m22, random);
  s.at = random.chance(2) ? point{24, 24} : near(6.25);
  const double m11 = 1 + unit * 2 * random.integer(-4, 4);
  s.tensor = {m11, 1 + unit * 2 * random.integer(-4, 4), 1};
  return s;
}

}  // namespace asterism::challenge
