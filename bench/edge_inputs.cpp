// SPDX-License-Identifier: MIT
//
// Generates questions about four sites.
#include <optional>

#include "asterism/kernels/double_kernel.hpp"
#include "inputs.hpp"
#include "metrics.hpp"

namespace asterism::bench {
using namespace internal;

namespace {

// A metric field, from which the sites of a question have their tensors.
struct field {
  double condition = 0, angle = 0;  // of condition 0: the swirl; of 1: the identity
  metric_tensor at(const point& p) const {
    if (condition == 1) return round_metric;
    return condition > 0 ? stretched(condition, angle + 1e-7 * (p.x + p.y)) : swirl(p);
  }
};

// Returns v, with x, w, y around it counter-clockwise.
struct ring {
  field metric;
  site v, x, y;
  displacement<double> to_w;

  site w(double factor) const {
    const point p = moved(v.position, to_w, factor);
    return {p, metric.at(p)};
  }
  edge_question question(double factor) const { return {v, w(factor), x, y}; }
};

ring draw_ring(const field& metric, random_source& random) {
  constexpr double edge_length = 0.15;
  const point v = random_point(random);
  const metric_tensor m = metric.at(v);
  double angle = random_angle(random);
  const auto next = [&] {
    angle += random.real(0.8, 1.3);
    return at_length(m, edge_length * random.real(0.8, 1.25), angle);
  };
  const auto at = [&](const displacement<double>& u) {
    const point p = moved(v, u);
    return site{p, metric.at(p)};
  };
  const site x = at(next());
  const displacement<double> to_w = next();
  return {metric, {v, m}, x, at(next()), to_w};
}

// Returns the factor of w's distance at which the answer changes, to the last place that plain
// doubles resolve.
std::optional<double> find_flip(const ring& r) {
  const double_kernel plain;
  const auto accepted = [&](double factor) {
    const auto [v, w, x, y] = r.question(factor);
    return plain.edge_test(v, w, x, y);
  };
  double yes = 0.3, no = 3;
  if (!accepted(yes) || accepted(no)) return std::nullopt;
  for (int halving = 0; halving < 56; ++halving) {
    const double middle = 0.5 * (yes + no);
    (accepted(middle) ? yes : no) = middle;
  }
  return yes;
}

edge_question near_flip(const field& metric, double closeness, random_source& random) {
  for (;;) {
    const ring r = draw_ring(metric, random);
    const double side = (random.bits() & 1U) != 0 ? closeness : -closeness;
    if (const auto flip = find_flip(r)) return r.question(*flip * (1 + side));
  }
}

// A swirl about c does not change by a quarter turn, so that all four sites are equally far from c
// in their metrics. v and w are half a turn apart.
edge_question four_site_tie(random_source& random) {
  const point c{few_bits(random), few_bits(random)};
  const double a = few_bits(random), b = few_bits(random);
  const auto at = [&](double x, double y) { return site{{c.x + x, c.y + y}, swirl({x, y})}; };
  return {at(a, b), at(-a, -b), at(b, -a), at(-b, a)};
}

// (5, 0), (4, 3), (3, 4) and their reflections are on one circle. They are scaled and shifted
// exactly.
edge_question cocircular(random_source& random) {
  constexpr std::array<std::array<int, 2>, 12> circle = {{{5, 0},
                                                          {4, 3},
                                                          {3, 4},
                                                          {0, 5},
                                                          {-3, 4},
                                                          {-4, 3},
                                                          {-5, 0},
                                                          {-4, -3},
                                                          {-3, -4},
                                                          {0, -5},
                                                          {3, -4},
                                                          {4, -3}}};
  const double radius = few_bits(random);
  const point c{few_bits(random), few_bits(random)};
  const auto start = static_cast<std::size_t>(random.integer(0, 11));
  const auto at = [&](std::size_t k) {
    const auto& [x, y] = circle[(start + k) % circle.size()];
    return site{{c.x + x * radius, c.y + y * radius}, round_metric};
  };
  return {at(0), at(6), at(9), at(3)};
}

edge_question grid_square(const field& metric, random_source& random) {
  const double i = random.integer(-8, 8), j = random.integer(-8, 8);
  const auto at = [&](double x, double y) { return site{{x, y}, metric.at({x / 8, y / 8})}; };
  return {at(i, j), at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)};
}

edge_question far_off(edge_question sites) {
  for (site& s : sites)
    s.position = {1e8 + 1e-4 * s.position.x, 1e8 + 1e-4 * s.position.y};  // neighbours 1e-5 apart
  return sites;
}

bool distinct(const edge_question& s) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (s[i].position == s[j].position) return false;
  return true;
}

edge_question draw(input_class which, bool round, random_source& random) {
  field metric;
  if (round) metric.condition = 1;
  switch (which) {
    case input_class::one_ulp: {
      edge_question q = near_flip(metric, 0, random);
      q[1].position = nudged(q[1].position, random);
      return q;
    }
    case input_class::degenerate:
      return round ? cocircular(random) : four_site_tie(random);
    case input_class::grid:
      return grid_square(metric, random);
    case input_class::up:
    case input_class::down: {
      edge_question q = draw_ring(metric, random).question(1);
      for (site& s : q) s = scaled(s, which == input_class::up ? 400 : -400);
      return q;
    }
    case input_class::offset:
      return far_off(draw_ring(metric, random).question(1));
    case input_class::condition:
      if (!round) metric = {1e12, random_angle(random)};
      return draw_ring(metric, random).question(1);
    default:
      return draw_ring(metric, random).question(1);
  }
}

std::vector<edge_question> draw_many(input_class which, bool round, std::size_t count,
                                     std::uint64_t seed) {
  random_source random(seed);
  std::vector<edge_question> questions;
  questions.reserve(count);
  while (questions.size() < count) {
    const edge_question q = draw(which, round, random);
    if (distinct(q)) questions.push_back(q);
  }
  return questions;
}

std::vector<edge_question> draw_near(const field& metric, double closeness, std::size_t count,
                                     std::uint64_t seed) {
  random_source random(seed);
  std::vector<edge_question> questions;
  questions.reserve(count);
  for (std::size_t k = 0; k < count; ++k) questions.push_back(near_flip(metric, closeness, random));
  return questions;
}

}  // namespace

std::vector<edge_question> edge_questions(input_class which, std::size_t count,
                                          std::uint64_t seed) {
  return draw_many(which, false, count, seed);
}

std::vector<edge_question> circle_questions(input_class which, std::size_t count,
                                            std::uint64_t seed) {
  return draw_many(which, true, count, seed);
}

std::vector<edge_question> edge_questions_near(double closeness, std::size_t count,
                                               std::uint64_t seed) {
  return draw_near({}, closeness, count, seed);
}

std::vector<edge_question> circle_questions_near(double closeness, std::size_t count,
                                                 std::uint64_t seed) {
  return draw_near({1, 0}, closeness, count, seed);
}

}  // namespace asterism::bench
