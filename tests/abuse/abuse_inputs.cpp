// SPDX-License-Identifier: MIT
#include "abuse_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/kernels/exact_kernel.hpp"

namespace asterism::abuse {
namespace {

double small_integer(random_source& random, int size) { return random.integer(-size, size); }

point integer_point(random_source& random, int size) {
  return {small_integer(random, size), small_integer(random, size)};
}

metric_tensor integer_metric(random_source& random, int size) {
  return {double(random.integer(1, size)), small_integer(random, size / 2),
          double(random.integer(1, size))};
}

// L L^T with a random triangular L.
metric_tensor real_metric(random_source& random) {
  const double a = random.real(0.3, 3), b = random.real(-2, 2), c = random.real(0.3, 3);
  return {a * a, a * b, b * b + c * c};
}

template <class Make>
scene each(random_source& random, Make make) {
  scene s;
  for (site& of : s.sites) of = make();
  s.at = {make().position.x, make().position.y};
  s.tensor = random.chance(2) ? s.sites[0].metric : metric_tensor{1, random.real(0.9, 1.1), 1};
  return s;
}

scene uniform(random_source& random) {
  return each(random, [&] {
    return site{{random.real(-1, 1), random.real(-1, 1)}, real_metric(random)};
  });
}

scene grid(random_source& random) {
  const metric_tensor shared = integer_metric(random, 3);
  const bool equal = random.chance(2);
  scene s = each(random, [&] {
    return site{integer_point(random, 2), equal ? shared : integer_metric(random, 3)};
  });
  s.tensor = {small_integer(random, 3), small_integer(random, 3), small_integer(random, 3)};
  return s;
}

// Draws from twelve points of one circle, with one metric: in-circle is zero.
scene cocircular(random_source& random) {
  constexpr std::array<std::array<int, 2>, 3> legs = {{{5, 0}, {3, 4}, {4, 3}}};
  const double scale = random.integer(1, 3);
  return each(random, [&] {
    const auto [a, b] = legs[static_cast<std::size_t>(random.integer(0, 2))];
    const double x = random.chance(2) ? a : -a, y = random.chance(2) ? b : -b;
    const bool exchange = random.chance(2);
    return site{{exchange ? y : x, exchange ? x : y}, {scale, 0, scale}};
  });
}

// The origin is at squared distance beta from all sites: four bisectors meet there.
scene common_point(random_source& random) {
  const double beta = random.integer(2, 30);
  scene s = each(random, [&] {
    const double x = random.chance(2) ? 1 : -1, y = small_integer(random, 3);
    const double m12 = small_integer(random, 4), m22 = random.integer(1, 5);
    const double m11 = beta - 2 * m12 * x * y - m22 * y * y;
    return random.chance(2) ? site{{x, y}, {m11, m12, m22}} : site{{y, x}, {m22, m12, m11}};
  });
  s.at = {0, 0};
  return s;
}

// Sites on a line, a point on it too.
scene collinear(random_source& random) {
  const point start = integer_point(random, 3), step = integer_point(random, 2);
  return each(random, [&] {
    const double k = small_integer(random, 4);
    return site{{start.x + k * step.x, start.y + k * step.y}, integer_metric(random, 4)};
  });
}

// v and w are images of each other in the line Y = 0, and everything else is on it.
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

scene exactly_degenerate(random_source& random) {
  constexpr std::array constructions = {cocircular, common_point, collinear, mirror_images};
  scene s = constructions[static_cast<std::size_t>(random.integer(0, 3))](random);
  const double a = small_integer(random, 3), b = small_integer(random, 3);
  s.tensor = {a * a, a * b, b * b};  // semidefinite
  return s;
}

double neighbour(double x, random_source& random) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(x, random.chance(2) ? infinity : -infinity);
}

std::array<double*, 5> numbers_of(site& s) {
  return {&s.position.x, &s.position.y, &s.metric.m11, &s.metric.m12, &s.metric.m22};
}

// Exactly degenerate but for one number, moved to the next double (of zero: a relative unit).
scene one_ulp_away(random_source& random) {
  scene s = exactly_degenerate(random);
  double& number = *numbers_of(s.sites[static_cast<std::size_t>(
      random.integer(0, 3))])[static_cast<std::size_t>(random.integer(0, 4))];
  number = number == 0 ? (random.chance(2) ? 0x1p-53 : -0x1p-53) : neighbour(number, random);
  if (random.chance(3)) s.at.x = neighbour(s.at.x, random);
  s.tensor.m12 = neighbour(s.tensor.m12, random);
  return s;
}

// Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems" (2008): the
// neighbourhood of (1/2, 1/2), one unit in the last place a step, against the line through (12, 12)
// and (24, 24).
scene kettner(random_source& random) {
  constexpr double unit = 0x1p-53;
  const auto near = [&](double x) { return x + unit * random.integer(0, 255); };
  const metric_tensor m = random.chance(2) ? metric_tensor{1, 0, 1} : integer_metric(random, 3);
  scene s;
  s.sites = {site{{near(0.5), near(0.5)}, m}, site{{12, 12}, m}, site{{near(0.5), near(0.5)}, m},
             site{{24, 24}, m}};
  if (random.chance(2)) s.sites[3].position = {near(12), near(12)};
  if (random.chance(3)) s.sites[2].metric.m22 = neighbour(m.m22, random);
  s.at = random.chance(2) ? point{24, 24} : point{near(6.25), near(6.25)};
  s.tensor = {1 + unit * 2 * random.integer(-4, 4), 1 + unit * 2 * random.integer(-4, 4), 1};
  return s;
}

void scale(scene& s, int coordinates, int metrics) {
  const auto scale_point = [&](point& p) {
    p = {std::ldexp(p.x, coordinates), std::ldexp(p.y, coordinates)};
  };
  const auto scale_metric = [&](metric_tensor& m) {
    m = {std::ldexp(m.m11, metrics), std::ldexp(m.m12, metrics), std::ldexp(m.m22, metrics)};
  };
  for (site& of : s.sites) {
    scale_point(of.position);
    scale_metric(of.metric);
  }
  scale_point(s.at);
  scale_metric(s.tensor);
}

scene any_size_one(random_source& random) {
  constexpr std::array classes = {uniform, exactly_degenerate, one_ulp_away, grid, kettner};
  return classes[static_cast<std::size_t>(random.integer(0, 4))](random);
}

template <int Exponent>
scene scaled(random_source& random) {
  scene s = any_size_one(random);
  const auto pick = [&] { return random.integer(-1, 1) * Exponent; };
  const int coordinates = random.chance(2) ? Exponent : -Exponent;
  scale(s, coordinates, pick());
  return s;
}

scene far_offset(random_source& random) {
  const metric_tensor m = real_metric(random);
  const bool equal = random.chance(2);
  return each(random, [&] {
    metric_tensor own = m;
    if (!equal) own.m11 *= random.real(1, 1.5);
    return site{{1e8 + 1e-6 * random.integer(-4, 4), -1e8 + 1e-6 * random.integer(-4, 4)}, own};
  });
}

// Condition number s about an integer direction (a, b): s n n^T + t t^T.
scene ill_conditioned(random_source& random) {
  scene s = each(random, [&] {
    double stretch = random.real(1, 10);
    for (int k = random.integer(4, 11); k > 0; --k) stretch *= 10;
    const double a = random.integer(1, 9), b = small_integer(random, 9);
    return site{{random.real(-1, 1), random.real(-1, 1)},
                {stretch * a * a + b * b, (stretch - 1) * a * b, stretch * b * b + a * a}};
  });
  if (random.chance(3))
    for (site& of : s.sites) of.metric = s.sites[0].metric;
  return s;
}

scene mixed_sizes(random_source& random) {
  return each(random, [&] {
    const double size = std::ldexp(1, random.integer(-30, 30));
    const metric_tensor m = integer_metric(random, 4);
    const double factor = std::ldexp(1, random.integer(-60, 60));
    return site{{random.real(-size, size), random.real(-size, size)},
                {factor * m.m11, factor * m.m12, factor * m.m22}};
  });
}

// Ordinary numbers beside subnormal ones, which decide: a processor that flushes takes them for
// zero, and then finds metrics equal and points ordered that are not.
scene subnormal_parts(random_source& random) {
  scene s = random.chance(2) ? exactly_degenerate(random) : grid(random);
  const auto tiny = [&] { return std::ldexp(small_integer(random, 7), -1074 + 3); };
  for (site& of : s.sites) {
    for (double* number : numbers_of(of))
      if (*number == 0) *number = tiny();
    if (random.chance(4)) of.position = {tiny(), tiny()};
  }
  if (s.at.x == 0) s.at.x = tiny();
  if (random.chance(2)) s.tensor = {tiny(), tiny(), tiny()};
  return s;
}

constexpr std::array classes = {input_class{"uniform", uniform},
                                input_class{"one ulp from degenerate", one_ulp_away},
                                input_class{"exactly degenerate", exactly_degenerate},
                                input_class{"grid", grid},
                                input_class{"Kettner neighbourhoods", kettner},
                                input_class{"scaled by 2^+-400", scaled<400>},
                                input_class{"scaled by 2^+-1000", scaled<1000>},
                                input_class{"1e-6 apart at 1e8", far_offset},
                                input_class{"condition to 1e12", ill_conditioned},
                                input_class{"mixed sizes", mixed_sizes},
                                input_class{"subnormal parts", subnormal_parts}};

bool is_finite(const site& s) {
  return std::isfinite(s.position.x) && std::isfinite(s.position.y) &&
         std::isfinite(s.metric.m11) && std::isfinite(s.metric.m12) && std::isfinite(s.metric.m22);
}

}  // namespace

std::span<const input_class> input_classes() { return classes; }

bool is_valid(const scene& s) {
  const exact_kernel kernel;
  if (!is_finite(site{s.at, s.tensor})) return false;
  for (std::size_t i = 0; i < s.sites.size(); ++i) {
    if (!is_finite(s.sites[i]) || !kernel.is_positive_definite(s.sites[i].metric)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (s.sites[i].position == s.sites[j].position) return false;
  }
  return true;
}

batch_record cut_record(predicate question, const scene& s) {
  batch_record record{question, {}};
  auto out = record.numbers.begin();
  const auto add_point = [&](const point& p) {
    *out++ = p.x;
    *out++ = p.y;
  };
  const auto add_metric = [&](const metric_tensor& m) {
    for (const double number : {m.m11, m.m12, m.m22}) *out++ = number;
  };
  if (question == predicate::is_positive_definite) {
    add_metric(s.tensor);
  } else if (question == predicate::orientation) {
    add_point(s.sites[0].position);
    add_point(s.sites[1].position);
    add_point(s.at);
  } else if (question == predicate::in_circle) {
    add_metric(s.sites[0].metric);
    for (const site& of : s.sites) add_point(of.position);
  } else {
    const record_shape shape = shape_of(question);
    for (std::size_t k = 0; k < shape.sites; ++k) {
      add_point(s.sites[k].position);
      add_metric(s.sites[k].metric);
    }
    if (shape.points > 0) add_point(s.at);
  }
  return record;
}

batch_record draw_record(const input_class& from, predicate question, random_source& random) {
  for (int attempts = 0; attempts < 10000; ++attempts)
    if (const scene s = from.attempt(random); is_valid(s)) return cut_record(question, s);
  // No class fails that often; the unit square keeps the contract if one did.
  const metric_tensor m = {1, 0, 1};
  return cut_record(question,
                    {{site{{0, 0}, m}, site{{1, 1}, m}, site{{1, 0}, m}, site{{0, 1}, m}}, {}, m});
}

}  // namespace asterism::abuse
