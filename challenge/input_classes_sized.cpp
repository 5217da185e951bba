// SPDX-License-Identifier: MIT
//
// Makes scenes of unusual sizes: scaled, offset, stretched, mixed, subnormal; and ordinary ones.
#include <array>
#include <cmath>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/challenge/scene_parts.hpp"

namespace asterism::challenge {
namespace {

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
  constexpr std::array classes = {uniform, degenerate, one_ulp, grid, kettner};
  return classes[static_cast<std::size_t>(random.integer(0, 4))](random);
}

scene scaled(random_source& random, int exponent) {
  scene s = any_size_one(random);
  const int coordinates = random.chance(2) ? exponent : -exponent;
  scale(s, coordinates, random.integer(-1, 1) * exponent);
  return s;
}

point real_point(random_source& random, double size) {
  const double x = random.real(-size, size);
  return {x, random.real(-size, size)};
}

}  // namespace

scene uniform(random_source& random) {
  return each(random, [&] {
    const point p = real_point(random, 1);
    return site{p, real_metric(random)};
  });
}

scene scaled_400(random_source& random) { return scaled(random, 400); }
scene scaled_1000(random_source& random) { return scaled(random, 1000); }

scene offset(random_source& random) {
  const metric_tensor m = real_metric(random);
  const bool equal = random.chance(2);
  return each(random, [&] {
    metric_tensor own = m;
    if (!equal) own.m11 *= random.real(1, 1.5);
    const double x = 1e8 + 1e-6 * random.integer(-4, 4);
    return site{{x, -1e8 + 1e-6 * random.integer(-4, 4)}, own};
  });
}

// Makes a tensor of condition number s about an integer direction (a, b): s n n^T + t t^T.
scene ill_conditioned(random_source& random) {
  scene s = each(random, [&] {
    double stretch = random.real(1, 10);
    for (int k = random.integer(4, 11); k > 0; --k) stretch *= 10;
    const double a = random.integer(1, 9), b = small_integer(random, 9);
    return site{real_point(random, 1),
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
    return site{real_point(random, size), {factor * m.m11, factor * m.m12, factor * m.m22}};
  });
}

// Makes subnormal numbers: a processor that flushes treats them as zero, so that different metrics
// are equal for it, and the order of points is another one.
scene subnormal(random_source& random) {
  scene s = random.chance(2) ? degenerate(random) : grid(random);
  const auto tiny = [&] { return std::ldexp(small_integer(random, 7), -1074 + 3); };
  for (site& of : s.sites) {
    for (double* number :
         {&of.position.x, &of.position.y, &of.metric.m11, &of.metric.m12, &of.metric.m22})
      if (*number == 0) *number = tiny();
    if (random.chance(4)) of.position = {of.position.x, tiny()};
  }
  if (s.at.x == 0) s.at.x = tiny();
  if (random.chance(2)) {
    const double m11 = tiny(), m12 = tiny();
    s.tensor = {m11, m12, tiny()};
  }
  return s;
}

}  // namespace asterism::challenge
