// SPDX-License-Identifier: MIT
//
// Generates questions about two sites and a point, and about three points.
#include "inputs.hpp"
#include "metrics.hpp"

namespace asterism::bench {
using namespace internal;

namespace {

point_question uniform(random_source& random) {
  const point v = random_point(random), w = random_point(random), q = random_point(random);
  return {{v, swirl(v)}, {w, swirl(w)}, q};
}

// Returns the point of the bisector on the ray from v at an angle of `aside` radians from the
// direction of w.
point on_bisector(const site& v, const site& w, double aside, double factor) {
  const auto d = between(v.position, w.position);
  const displacement<double> u{d.x * std::cos(aside) - d.y * std::sin(aside),
                               d.x * std::sin(aside) + d.y * std::cos(aside)};
  const auto seen = apply(w.metric, d);
  const double a = squared_length(v.metric, u) - squared_length(w.metric, u), half_b = dot(u, seen),
               c = dot(d, seen);
  return moved(v.position, u, factor * c / (half_b + std::sqrt(half_b * half_b + a * c)));
}

// Returns a point of the line on which v sees a right angle to w, moved by a step towards or away
// from w.
point on_wedge_side(const site& v, const site& w, double length, double step) {
  const auto d = between(v.position, w.position);
  const auto seen = apply(v.metric, d);
  const double unit = length / std::sqrt(dot(seen, seen));
  return {v.position.x - unit * seen.y + step * d.x, v.position.y + unit * seen.x + step * d.y};
}

point_question near_border(random_source& random, border near, double closeness) {
  const point_question base = uniform(random);
  const auto& [v, w, unused] = base;
  const double side = (random.bits() & 1U) != 0 ? closeness : -closeness;
  if (near == border::wedge) return {v, w, on_wedge_side(v, w, random.real(0.25, 1), side)};
  const point q = on_bisector(v, w, random.real(-0.7, 0.7), 1 + side);
  return std::isfinite(q.x) && std::isfinite(q.y) ? point_question{v, w, q} : base;
}

// The shear (x, y) -> (x + y, y) maps v's view of q to w's, so that both distances are equal. They
// are rounded differently.
point_question on_bisector_exactly(random_source& random) {
  const point q{few_bits(random), few_bits(random)};
  const displacement<double> u{few_bits(random), few_bits(random)};
  const metric_tensor m = {1 + std::abs(few_bits(random)), 0.5 * few_bits(random),
                           1 + std::abs(few_bits(random))};
  const metric_tensor sheared = {m.m11, m.m12 - m.m11, m.m11 - 2 * m.m12 + m.m22};
  return {{{q.x - u.x, q.y - u.y}, m}, {{q.x + u.x + u.y, q.y + u.y}, sheared}, q};
}

point_question on_wedge_side_exactly(random_source& random) {
  const point v{few_bits(random), few_bits(random)}, w{few_bits(random), few_bits(random)};
  const metric_tensor m = {1 + std::abs(few_bits(random)), 0.5 * few_bits(random),
                           1 + std::abs(few_bits(random))};
  const auto seen = apply(m, between(v, w));
  return {{v, m}, {w, round_metric}, {v.x - seen.y, v.y + seen.x}};
}

point_question on_grid(random_source& random) {
  const auto draw = [&] { return static_cast<double>(random.integer(-8, 8)); };
  const point v{draw(), draw()}, q{draw(), draw()};
  point w{draw(), draw()};
  if (w == v) w.x += 1;
  const auto metric = [&] {
    return metric_tensor{static_cast<double>(random.integer(2, 4)),
                         static_cast<double>(random.integer(-1, 1)),
                         static_cast<double>(random.integer(2, 4))};
  };
  return {{v, metric()}, {w, metric()}, q};
}

point far_off(const point& p) { return {1e8 + 1e-6 * p.x, 1e8 + 1e-6 * p.y}; }

point_question draw(input_class which, border near, random_source& random) {
  point_question q = uniform(random);
  switch (which) {
    case input_class::uniform:
      return q;
    case input_class::one_ulp:
      q = near_border(random, near, 0);
      return {q.v, q.w, nudged(q.q, random)};
    case input_class::degenerate:
      return near == border::wedge ? on_wedge_side_exactly(random) : on_bisector_exactly(random);
    case input_class::grid:
      return on_grid(random);
    case input_class::up:
    case input_class::down: {
      const int exponent = which == input_class::up ? 400 : -400;
      return {scaled(q.v, exponent),
              scaled(q.w, exponent),
              {std::ldexp(q.q.x, exponent), std::ldexp(q.q.y, exponent)}};
    }
    case input_class::offset: {
      const auto place = [](const point& p) { return far_off({100 * p.x, 100 * p.y}); };
      return {{place(q.v.position), q.v.metric}, {place(q.w.position), q.w.metric}, place(q.q)};
    }
    case input_class::condition:
      q.v.metric = stretched(1e12, random_angle(random));
      q.w.metric = stretched(1e12, random_angle(random));
      return q;
  }
  return q;
}

line_question draw_line(input_class which, random_source& random) {
  const point p = random_point(random), q = random_point(random), r = random_point(random);
  const auto along = [&](double t) { return point{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; };
  switch (which) {
    case input_class::one_ulp:
      return {p, q, nudged(along(random.real(-2, 2)), random)};
    case input_class::degenerate: {
      const point a{few_bits(random), few_bits(random)};
      const displacement<double> u{few_bits(random), few_bits(random)};
      return {a, moved(a, u, 1 + random.integer(1, 1 << 20)),
              moved(a, u, 1 + random.integer(1, 1 << 20))};
    }
    case input_class::grid: {
      const auto draw = [&] { return static_cast<double>(random.integer(-8, 8)); };
      return {{{draw(), draw()}, {draw(), draw()}, {draw(), draw()}}};
    }
    case input_class::up:
    case input_class::down: {
      const int e = which == input_class::up ? 400 : -400;
      const auto scale = [e](const point& a) {
        return point{std::ldexp(a.x, e), std::ldexp(a.y, e)};
      };
      return {scale(p), scale(q), scale(r)};
    }
    case input_class::offset:
      return {far_off(p), far_off(q), far_off(r)};
    default:
      return {p, q, r};
  }
}

}  // namespace

std::vector<point_question> point_questions(input_class which, border near, std::size_t count,
                                            std::uint64_t seed) {
  random_source random(seed);
  std::vector<point_question> questions;
  questions.reserve(count);
  while (questions.size() < count) {
    const point_question q = draw(which, near, random);
    if (q.v.position != q.w.position) questions.push_back(q);
  }
  return questions;
}

std::vector<point_question> point_questions_near(border near, double closeness, std::size_t count,
                                                 std::uint64_t seed) {
  random_source random(seed);
  std::vector<point_question> questions;
  questions.reserve(count);
  for (std::size_t k = 0; k < count; ++k) questions.push_back(near_border(random, near, closeness));
  return questions;
}

std::vector<line_question> line_questions(input_class which, std::size_t count,
                                          std::uint64_t seed) {
  random_source random(seed);
  std::vector<line_question> questions;
  questions.reserve(count);
  for (std::size_t k = 0; k < count; ++k) questions.push_back(draw_line(which, random));
  return questions;
}

}  // namespace asterism::bench
