// SPDX-License-Identifier: MIT
//
// Tests a gap of a star against the exact arithmetics: whatever it decides is right, in every
// floating-point environment and wherever rounding could matter; on smooth input it decides most
// questions.
#include <cmath>
#include <limits>

#include "star_gap_answers.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::gap_questions;

TEST_CASE("what a gap decides is right, in every family of input", "[star_gap]") {
  for (const family& f : families) {
    DYNAMIC_SECTION(f.name) {
      sequence random{11};
      int decided = 0;
      for (int k = 0; k < 3000; ++k) {
        const std::uint64_t replay = random.state();
        const auto q = draw(f, random);
        if (!q) continue;
        const uncertain_bool answer = ask(*q);
        decided += answer.certain();
        check_right(*q, answer, replay);
      }
      CHECK(decided > (f.grid ? 100 : f.unrelated ? 250 : 500));  // half of a grid's are ties
    }
  }
}

TEST_CASE("what a gap decides is right at the border of what it knows", "[star_gap]") {
  for (const family& f : families) {
    if (f.grid) continue;
    DYNAMIC_SECTION(f.name) {
      sequence random{12};
      int decided = 0;
      for (int k = 0; k < 300; ++k) {
        const std::uint64_t replay = random.state();
        if (const auto drawn = draw(f, random)) {
          const question q = at_the_border_of_knowledge(*drawn, random.integer(0, 1) == 1);
          const uncertain_bool answer = ask(q);
          decided += answer.certain();
          check_right(q, answer, replay);
        }
      }
      CHECK(decided > 50);
    }
  }
}

TEST_CASE("rounding modes and flushing leave what a gap decides right", "[star_gap][environment]") {
  sequence random{13};
  int decided = 0;
  for (int k = 0; k < 4000; ++k) {
    const std::uint64_t replay = random.state();
    const auto drawn = draw(families[k % std::size(families)], random);
    if (!drawn) continue;
    const bool near = k % 16 == 3 && !families[k % std::size(families)].grid;
    const question q =
        near ? at_the_border_of_knowledge(*drawn, random.integer(0, 1) == 1) : *drawn;
    const bool flush = random.integer(0, 1) == 1;
    const auto round = static_cast<std::size_t>(k) / std::size(families);
    const uncertain_bool answer = [&] {
      const hostile_environment scope(directed_modes[round % 3], flush);
      return ask(q);
    }();
    decided += answer.certain();
    check_right(q, answer, replay);
  }
  CHECK(decided > 1000);
}

TEST_CASE("scaled by powers of two a gap is right or silent", "[star_gap][range]") {
  sequence random{14};
  const auto scaled = [](site s, int length, int metric) {
    s.position = {std::ldexp(s.position.x, length), std::ldexp(s.position.y, length)};
    s.metric = {std::ldexp(s.metric.m11, metric), std::ldexp(s.metric.m12, metric),
                std::ldexp(s.metric.m22, metric)};
    return s;
  };
  int decided = 0;
  for (int k = 0; k < 600; ++k) {
    const auto q = draw(families[2], random);
    if (!q) continue;
    const bool expected = second_route(*q);
    for (const int length : {-1000, -400, -181, -90, 90, 179, 400, 1000})
      for (const int metric : {-400, -140, 140, 400}) {
        const question far{scaled(q->v, length, metric), scaled(q->w, length, metric),
                           scaled(q->y, length, metric), scaled(q->x, length, metric)};
        const uncertain_bool answer = ask(far);
        decided += answer.certain();
        if (answer.certain()) CHECK(answer.value() == expected);
      }
  }
  CHECK(decided > 1000);
}

TEST_CASE("on smooth input a gap decides, whatever the condition number", "[star_gap][tiers]") {
  for (const double condition : {1.0, 1e4, 1e8, 1e12}) {
    sequence random{15};
    int asked = 0, decided = 0, yes = 0;
    for (int k = 0; k < 4000; ++k) {
      const metric_tensor base = stretched(condition, random.real(-4, 4));
      const double start = random.real(-4, 4), to_w = random.real(0.5, 1.3);
      const auto at = [&](double length, double angle) {
        const auto u = round_off(base, length, angle);
        return site{{u.x, u.y}, changed(base, 0.05, random)};
      };
      const site v = at(0, 0), y = at(random.real(0.8, 1.25), start),
                 w = at(power(random, 0.5, 2.7), start + to_w),
                 x = at(random.real(0.8, 1.25), start + to_w + random.real(0.5, 1.3));
      const uncertain_bool answer = star_gap(v, y, x).accepts(w);
      ++asked;
      decided += answer.certain();
      yes += answer.certainly(true);
    }
    INFO("condition " << condition << ": " << decided << " of " << asked);
    CHECK(decided >= 0.99 * asked);
    CHECK(yes > 1000);
    CHECK(decided - yes > 1000);
  }
}

// In the direction of x, w's bisector comes before x itself: the triangle of v, w and that point
// excludes nothing. In the directions where it excludes enough, x's bisector may be the later one.
// A single direction between these satisfies both conditions.
TEST_CASE("sites behind a neighbour are refused in doubles", "[star_gap][tiers]") {
  for (const double condition : {1.0, 1e4, 1e8}) {
    sequence random{19};
    int refused = 0, asked = 0;
    for (int k = 0; k < 4000; ++k) {
      const std::uint64_t replay = random.state();
      const metric_tensor base = stretched(condition, random.real(-4, 4));
      const double start = random.real(-4, 4), gap = random.real(0.6, 1.3),
                   aside = power(random, 1e-8, 0.3);
      const auto at = [&](double length, double angle) {
        const auto u = round_off(base, length, angle);
        return site{{u.x, u.y}, changed(base, 0.12, random)};
      };
      const site v = at(0, 0), y = at(random.real(0.9, 1.1), start),
                 x = at(random.real(0.9, 1.1), start + gap);
      const bool behind_x = random.integer(0, 1) == 1;
      const site w = at(random.real(1.5, 2), behind_x ? start + gap - aside : start + aside);
      const question q{v, w, y, x};
      ++asked;
      const uncertain_bool answer = ask(q);
      refused += answer.certainly(false);
      if (k % 8 == 0) check_right(q, answer, replay);
    }
    INFO("condition " << condition << ": " << refused << " of " << asked);
    CHECK(refused >= 0.99 * asked);
  }
}

TEST_CASE("ties, gaps of half a turn and more, and nonsense are undecided", "[star_gap]") {
  const metric_tensor round{1, 0, 1};
  const site v{{0, 0}, round}, y{{1, 0}, round}, x{{0, 1}, round}, w{{1, 1}, round};
  CHECK_FALSE(star_gap(v, y, x).accepts(w).certain());  // a square
  CHECK(star_gap(v, y, x).accepts({{0.99, 0.99}, round}).certainly(true));
  CHECK(star_gap(v, y, x).accepts({{1.01, 1.01}, round}).certainly(false));
  CHECK_FALSE(star_gap(v, x, y).accepts(w).certain());                // w is outside of this gap
  CHECK_FALSE(star_gap(v, y, x).accepts({{2, 0}, round}).certain());  // w is on a neighbour's ray
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK_FALSE(star_gap(v, y, x).accepts({{bad, 1}, round}).certain());
    CHECK_FALSE(star_gap(v, y, {{0, 1}, {bad, 0, 1}}).accepts(w).certain());
    CHECK_FALSE(star_gap({{0, 0}, {1, 0, bad}}, y, x).accepts(w).certain());
  }
  CHECK_FALSE(star_gap(v, y, y).accepts(w).certain());
  CHECK_FALSE(star_gap(v, v, x).accepts(w).certain());
}
