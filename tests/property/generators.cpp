// SPDX-License-Identifier: MIT
#include "generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace asterism::property {
namespace {

site make_site(double x, double y, double m11, double m12, double m22) {
  return {{x, y}, {m11, m12, m22}};
}

// Returns the tensor with eigenvalue `along` in the direction of the angle and `across` at a right
// angle to it.
metric_tensor stretched(double angle, double along, double across) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c};
}

point real_point(random_source& random, double size) {
  return {random.real(-size, size), random.real(-size, size)};
}

point integer_point(random_source& random, int size) {
  return {double(random.integer(-size, size)), double(random.integer(-size, size))};
}

metric_tensor integer_metric(random_source& random, int size) {
  return {double(random.integer(1, size)), double(random.integer(-size / 2, size / 2)),
          double(random.integer(1, size))};
}

template <class Make>
four_sites each(Make make) {
  four_sites sites;
  for (site& s : sites) s = make();
  return sites;
}

// Maps a construction in convenient coordinates to general ones: by a random integer matrix of
// determinant 1 and an integer translation. Exact for numbers of few digits.
four_sites sheared_and_moved(const four_sites& sites, random_source& random) {
  const double k = random.integer(-2, 2), l = random.integer(-1, 1);
  const bool exchange = random.chance(2);
  const point shift = integer_point(random, 3);
  four_sites moved;
  for (std::size_t i = 0; i < 4; ++i) {
    auto [p, m] = sites[i];
    p.x += k * p.y;  // the metric is mapped by the inverse, x - k y
    m = {m.m11, m.m12 - k * m.m11, m.m22 - 2 * k * m.m12 + k * k * m.m11};
    p.y += l * p.x;
    m = {m.m11 - 2 * l * m.m12 + l * l * m.m22, m.m12 - l * m.m22, m.m22};
    if (exchange) {
      std::swap(p.x, p.y);
      std::swap(m.m11, m.m22);
    }
    moved[i] = {{p.x + shift.x, p.y + shift.y}, m};
  }
  return moved;
}

// Four neighbouring sites in a field that rotates and stretches slowly, as a mesher asks about.
four_sites smooth_metrics(random_source& random) {
  const point centre = real_point(random, 1);
  const double spacing = random.real(0.01, 0.5), strength = random.real(0, 15);
  return each([&] {
    const point p = {centre.x + random.real(-spacing, spacing),
                     centre.y + random.real(-spacing, spacing)};
    return make_site(p.x, p.y, 1 + strength * p.x * p.x, strength * p.x * p.y,
                     1 + strength * p.y * p.y);
  });
}

four_sites independent_metrics(random_source& random) {
  return each([&] {
    const double along = std::exp2(random.real(-3, 3)), across = std::exp2(random.real(-3, 3));
    return site{real_point(random, 1), stretched(random.real(0, 3.2), along, across)};
  });
}

four_sites equal_metrics(random_source& random) {
  const metric_tensor m = stretched(random.real(0, 3.2), 1, std::exp2(random.real(-6, 6)));
  return each([&] { return site{real_point(random, 1), m}; });
}

four_sites three_equal_metrics(random_source& random) {
  four_sites sites = equal_metrics(random);
  sites[3].metric = stretched(random.real(0, 3.2), 1, std::exp2(random.real(-4, 4)));
  return shuffled(sites, random);
}

four_sites proportional_metrics(random_source& random) {
  const metric_tensor m = integer_metric(random, 4);
  return each([&] {
    const double factor = random.integer(1, 5);
    return site{integer_point(random, 4), {factor * m.m11, factor * m.m12, factor * m.m22}};
  });
}

four_sites small_integers(random_source& random) {
  return each([&] { return site{integer_point(random, 3), integer_metric(random, 4)}; });
}

four_sites tiny_integers(random_source& random) {
  return each([&] { return site{integer_point(random, 2), integer_metric(random, 2)}; });
}

four_sites grid(random_source& random) {
  const metric_tensor m = random.chance(2) ? metric_tensor{1, 0, 1} : integer_metric(random, 3);
  return each([&] { return site{integer_point(random, 2), m}; });
}

// Draws from the twelve integer points of a circle.
four_sites integer_points_on_circle(random_source& random) {
  constexpr std::array<std::array<int, 2>, 3> legs = {{{5, 0}, {3, 4}, {4, 3}}};
  return each([&] {
    const auto [a, b] = legs[static_cast<std::size_t>(random.integer(0, 2))];
    const int x = random.chance(2) ? a : -a, y = random.chance(2) ? b : -b;
    const bool exchange = random.chance(2);
    return make_site(exchange ? y : x, exchange ? x : y, 1, 0, 1);
  });
}

four_sites cocircular(random_source& random) {
  return sheared_and_moved(integer_points_on_circle(random), random);
}

// Sites on a circle around the middle of a field that stretches along circles or along rays. The
// middle is equally far from all four, though no two metrics are equal.
four_sites symmetric_field(random_source& random) {
  four_sites sites = integer_points_on_circle(random);
  const double strength = random.chance(2) ? 3 : 12;
  const bool along_circles = random.chance(2);
  for (site& s : sites) {
    s.position = {s.position.x / 4, s.position.y / 4};
    const auto [x, y] = s.position;
    s.metric = along_circles
                   ? metric_tensor{1 + strength * x * x, strength * x * y, 1 + strength * y * y}
                   : metric_tensor{1 + strength * y * y, -strength * x * y, 1 + strength * x * x};
  }
  return sites;
}

four_sites nearly_grid(random_source& random) {
  const metric_tensor m = {1, 0, 1};
  four_sites sites = each([&] { return site{integer_point(random, 2), m}; });
  sites[static_cast<std::size_t>(random.integer(0, 3))].metric = integer_metric(random, 3);
  return sites;
}

four_sites collinear(random_source& random) {
  const point start = integer_point(random, 3), step = integer_point(random, 2);
  return each([&] {
    const int k = random.integer(-4, 4);
    return site{{start.x + k * step.x, start.y + k * step.y}, integer_metric(random, 4)};
  });
}

// M (position) = (s, 0) and position . (s, 0) = s for all: the squared distances agree at the
// origin to first order, so every bisector is two lines through it. Up to two sites are drawn anew,
// without these conditions.
four_sites crossing_line_pairs(random_source& random) {
  const double s = random.integer(1, 3);
  four_sites sites = each([&] {
    const double b = random.integer(-3, 3), m = random.integer(1, 4);
    return make_site(1, b, s + m * b * b, -m * b, m);
  });
  for (std::size_t i = 2; i < 4; ++i)
    if (random.chance(2)) sites[i] = {integer_point(random, 3), integer_metric(random, 5)};
  return sheared_and_moved(shuffled(sites, random), random);
}

// M_v = M_w + lambda n n^T with n = M_w (w - v): the bisector is two parallel lines (or one line).
four_sites parallel_line_pairs(random_source& random) {
  four_sites sites = small_integers(random);
  const metric_tensor m = integer_metric(random, 3);
  const double lambda = random.integer(1, 3) * (random.chance(2) ? 1 : 0.25);
  const double dx = sites[1].position.x - sites[0].position.x;
  const double dy = sites[1].position.y - sites[0].position.y;
  const double nx = m.m11 * dx + m.m12 * dy, ny = m.m12 * dx + m.m22 * dy;
  sites[1].metric = m;
  sites[0].metric = {m.m11 + lambda * nx * nx, m.m12 + lambda * nx * ny, m.m22 + lambda * ny * ny};
  return random.chance(2) ? sites : shuffled(sites, random);
}

// The squared distances agree on all of the line Y = 0: every bisector contains it. Two sites may
// leave the family.
four_sites shared_line(random_source& random) {
  const double a = random.integer(1, 4), b = random.integer(-1, 1), m = random.integer(1, 4);
  four_sites sites = each([&] {
    const double h = (random.chance(2) ? 1 : -1) * std::ldexp(1, random.integer(-1, 2));
    return make_site(0, h, a, b / h, m / (h * h));
  });
  for (std::size_t i = 2; i < 4; ++i)
    if (random.chance(3)) sites[i] = {integer_point(random, 3), integer_metric(random, 5)};
  return sheared_and_moved(shuffled(sites, random), random);
}

// Returns a site at squared distance `beta` from the origin. The first coordinate of their
// difference is 1 or -1.
site at_distance_from_origin(double beta, random_source& random) {
  const double x = random.chance(2) ? 1 : -1, y = random.integer(-3, 3);
  const double m12 = random.integer(-4, 4), m22 = random.integer(1, 5);
  const site s = make_site(x, y, beta - 2 * m12 * x * y - m22 * y * y, m12, m22);
  return random.chance(2) ? s : make_site(y, x, m22, m12, s.metric.m11);
}

// The origin is equally far from three or four sites.
four_sites common_point(random_source& random) {
  const double beta = random.integer(2, 30);
  four_sites sites = each([&] { return at_distance_from_origin(beta, random); });
  if (random.chance(4)) sites[3] = {integer_point(random, 3), integer_metric(random, 5)};
  return sheared_and_moved(shuffled(sites, random), random);
}

// The origin is equally far from four sites, and a ray from v to it touches their bisector there.
// The shuffled order makes the first or the second site v.
four_sites tangency_at_common_point(random_source& random) {
  const double a = random.integer(1, 3), beta = random.integer(3, 40);
  const double m11 = random.integer(1, 5), m12 = random.integer(-4, 4);
  four_sites sites = each([&] { return at_distance_from_origin(beta, random); });
  sites[0] = make_site(-a, -1, m11, m12, beta - m11 * a * a - 2 * m12 * a);
  sites[1] = make_site(0, -1, random.integer(1, 6), 0, beta);
  if (random.chance(2)) sites[3] = {integer_point(random, 3), integer_metric(random, 6)};
  return sheared_and_moved(shuffled(sites, random), random);
}

// v and w, or x and y, or both pairs, are images of each other in the line Y = 0. Sites on the line
// have metrics with axes along it. Bisectors of images contain the line.
four_sites mirror_images(random_source& random) {
  const auto image = [](const site& s) {
    return make_site(s.position.x, -s.position.y, s.metric.m11, -s.metric.m12, s.metric.m22);
  };
  four_sites sites = small_integers(random);
  sites[1] = image(sites[0]);
  if (random.chance(2)) {
    sites[3] = image(sites[2]);
  } else {
    for (std::size_t i = 2; i < 4; ++i) {
      sites[i].position.y = 0;
      sites[i].metric.m12 = 0;
    }
  }
  return sheared_and_moved(shuffled(sites, random), random);
}

// Draws a case of another kind, and moves one number by a unit in the last place.
four_sites one_ulp_away(random_source& random) {
  const auto all = kinds();
  four_sites sites = draw(all[static_cast<std::size_t>(random.integer(4, 17))], random);
  site& s = sites[static_cast<std::size_t>(random.integer(0, 3))];
  const std::array<double*, 5> numbers = {&s.position.x, &s.position.y, &s.metric.m11,
                                          &s.metric.m12, &s.metric.m22};
  double& number = *numbers[static_cast<std::size_t>(random.integer(0, 4))];
  const double infinity = std::numeric_limits<double>::infinity();
  number = number == 0 ? 0x1p-60 : std::nextafter(number, random.chance(2) ? infinity : -infinity);
  return sites;
}

four_sites far_from_origin(random_source& random) {
  const metric_tensor m = stretched(random.real(0, 3.2), 1e12, 1e12 * random.real(0.01, 1));
  const bool equal = random.chance(3);
  return each([&] {
    metric_tensor own = m;
    if (!equal) own.m11 *= random.real(1, 1.5);
    return site{{1e8 + 1e-6 * random.integer(-3, 3), -1e8 + 1e-6 * random.integer(-3, 3)}, own};
  });
}

four_sites ill_conditioned(random_source& random) {
  const double angle = random.real(0, 3.2), turn = random.real(0, 1e-3);
  const double ratio = std::pow(10, random.real(4, 12));
  return each([&] {
    return site{real_point(random, 1), stretched(angle + random.real(0, turn), 1, ratio)};
  });
}

four_sites mixed_sizes(random_source& random) {
  return each([&] {
    const double size = std::exp2(random.integer(-30, 30));
    const metric_tensor m = integer_metric(random, 4);
    const double factor = std::exp2(random.integer(-60, 60));
    return site{real_point(random, size), {factor * m.m11, factor * m.m12, factor * m.m22}};
  });
}

constexpr std::array all_kinds = {kind{"smooth metrics", smooth_metrics},
                                  kind{"independent metrics", independent_metrics},
                                  kind{"equal metrics", equal_metrics},
                                  kind{"three equal metrics", three_equal_metrics},
                                  kind{"proportional metrics", proportional_metrics},
                                  kind{"small integers", small_integers},
                                  kind{"tiny integers", tiny_integers},
                                  kind{"grid", grid},
                                  kind{"cocircular", cocircular},
                                  kind{"symmetric field", symmetric_field},
                                  kind{"nearly grid", nearly_grid},
                                  kind{"collinear", collinear},
                                  kind{"crossing line pairs", crossing_line_pairs},
                                  kind{"parallel line pairs", parallel_line_pairs},
                                  kind{"shared line", shared_line},
                                  kind{"common point", common_point},
                                  kind{"tangency at common point", tangency_at_common_point},
                                  kind{"mirror images", mirror_images},
                                  kind{"one ulp away", one_ulp_away},
                                  kind{"far from origin", far_from_origin},
                                  kind{"ill conditioned", ill_conditioned},
                                  kind{"mixed sizes", mixed_sizes}};

}  // namespace

std::span<const kind> kinds() { return all_kinds; }

const kind& kind_named(std::string_view name) {
  const auto found = std::find_if(all_kinds.begin(), all_kinds.end(),
                                  [name](const kind& k) { return k.name == name; });
  return found == all_kinds.end() ? all_kinds.front() : *found;
}

}  // namespace asterism::property
