// SPDX-License-Identifier: MIT
//
// Tests direction_cover against the exact arithmetics: whatever it refuses is refused, in every
// floating-point environment and up to the limit of its bounds; among neighbours with metrics
// stretched in different directions it decides most refusals.
#include "asterism/kernels/direction_cover.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

#include "asterism/kernels/filtered_kernel.hpp"
#include "gap_questions.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::gap_questions;

namespace {

bool refuses(const question& q) { return no_direction_is_left(q.v, q.w, q.x, q.y); }

void check_right(const question& q, const char* name, std::uint64_t replay) {
  if (!refuses(q)) return;
  INFO(name << ", replay: sequence{" << replay << "}");
  CHECK_FALSE(second_route(q));
}

// Moves w along its ray to the nearest place where the exact kernel refuses it.
question at_the_border(const question& q) { return moved_to_border(q, 20, 0.05, refuses); }

site anywhere(sequence& random, double condition) {
  return {{random.real(-1, 1), random.real(-1, 1)},
          stretched(power(random, 1, condition), random.real(-4, 4))};
}

}  // namespace

TEST_CASE("what the cover refuses is refused, in every family and at the border of what it knows",
          "[star_gap]") {
  for (const family& f : families) {
    DYNAMIC_SECTION(f.name) {
      sequence random{41};
      int refused = 0;
      for (int k = 0; k < 3000; ++k) {
        const std::uint64_t replay = random.state();
        const auto q = draw(f, random);
        if (!q) continue;
        refused += refuses(*q);
        check_right(*q, f.name, replay);
        if (k % 8 == 0 && !f.grid) check_right(at_the_border(*q), f.name, replay);
      }
      CHECK(refused > (f.nearly_flat ? 5 : 100));
    }
  }
}

// Draws x and y anywhere, since insertion_test is defined for all their places.
TEST_CASE("what the cover refuses is refused wherever the neighbours are", "[star_gap]") {
  sequence random{42};
  int refused = 0, accepted = 0;
  for (int k = 0; k < 6000; ++k) {
    const std::uint64_t replay = random.state();
    const double condition = k % 3 == 0 ? 2 : k % 3 == 1 ? 100 : 1e4;
    const question q{anywhere(random, condition), anywhere(random, condition),
                     anywhere(random, condition), anywhere(random, condition)};
    const bool answer = second_route(q);
    accepted += answer;
    if (!refuses(q)) continue;
    ++refused;
    INFO("replay: sequence{" << replay << "}");
    CHECK_FALSE(answer);
  }
  CHECK(refused > 500);
  CHECK(accepted > 300);
}

// Changes each question slightly, many times, so that the bounds are tested on both sides.
TEST_CASE("no accepted site is refused by the cover, near the border of acceptance", "[star_gap]") {
  sequence random{43};
  int accepted = 0;
  for (int k = 0; k < 400; ++k) {
    const std::uint64_t replay = random.state();
    const double condition = power(random, 2, 1e4);
    question q{anywhere(random, condition), anywhere(random, condition),
               anywhere(random, condition), anywhere(random, condition)};
    const site from = q.w;
    if (refuses(q) || !second_route(q)) continue;
    const site to = anywhere(random, condition);
    for (int step = 1; step <= 24; ++step) {
      const double t = step / 24.0;
      const auto blend = [t](double a, double b) { return (1 - t) * a + t * b; };
      q.w = {{blend(from.position.x, to.position.x), blend(from.position.y, to.position.y)},
             {blend(from.metric.m11, to.metric.m11), blend(from.metric.m12, to.metric.m12),
              blend(from.metric.m22, to.metric.m22)}};
      if (!refuses(q)) continue;
      INFO("replay: sequence{" << replay << "}, step " << step);
      CHECK_FALSE(second_route(q));
    }
    ++accepted;
  }
  CHECK(accepted > 20);
}

TEST_CASE("rounding modes and flushing leave what the cover refuses right",
          "[star_gap][environment]") {
  sequence random{44};
  for (int k = 0; k < 4000; ++k) {
    const std::uint64_t replay = random.state();
    const family& f = families[static_cast<std::size_t>(k) % std::size(families)];
    const auto drawn = draw(f, random);
    if (!drawn) continue;
    const question q = k % 16 == 3 && !f.grid ? at_the_border(*drawn) : *drawn;
    const bool flush = random.integer(0, 1) == 1;
    const auto round = static_cast<std::size_t>(k) / std::size(families);
    const bool refused = [&] {
      const hostile_environment scope(directed_modes[round % 3], flush);
      return refuses(q);
    }();
    INFO(f.name << ", replay: sequence{" << replay << "}");
    if (refused) CHECK_FALSE(second_route(q));
  }
}

TEST_CASE("numbers out of range are not refused, nor is one's own mirror image", "[star_gap]") {
  const metric_tensor round{1, 0, 1};
  const site v{{0, 0}, round}, x{{0, 1}, round}, y{{1, 0}, round}, far{{3, 3}, round};
  CHECK(no_direction_is_left(v, far, x, y));
  CHECK_FALSE(no_direction_is_left(v, {{3, 3}, {1e300, 0, 1e300}}, x, y));
  CHECK_FALSE(no_direction_is_left(v, {{1e200, 1e200}, round}, x, y));
  CHECK_FALSE(no_direction_is_left({{0, 0}, {1e-300, 0, 1e300}}, far, x, y));
  // Four sites on one circle are a tie.
  CHECK_FALSE(no_direction_is_left(v, {{1, 1}, round}, x, y));
}

TEST_CASE("among neighbours stretched in directions of their own doubles decide most",
          "[star_gap]") {
  sequence random{45};
  tier_counters decided;
  const filtered_kernel kernel(decided);
  int refused = 0, by_cover = 0;
  const family turned{"turned", 400, 1e-3, 1, 0, false, false, false, false, true};
  for (int k = 0; k < 4000; ++k) {
    const auto q = draw(turned, random);
    if (!q || second_route(*q)) continue;
    ++refused;
    by_cover += refuses(*q) || no_direction_is_left(q->w, q->v, q->x, q->y);
    CHECK_FALSE(kernel.edge_test(q->v, q->w, q->x, q->y));
  }
  CAPTURE(refused, by_cover);
  CHECK(refused > 1200);
  CHECK(by_cover > refused * 78 / 100);
  CHECK(decided.at(predicate::edge_test, tier::semi_static) >
        static_cast<std::uint64_t>(refused) * 78 / 100);
}
