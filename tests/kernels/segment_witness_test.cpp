// SPDX-License-Identifier: MIT
//
// An edge accepted by the point in which it crosses the bisector of its ends is accepted by every
// other method, in every floating-point environment; on smooth input most edges are accepted.
#include "asterism/kernels/segment_witness.hpp"

#include <cmath>

#include "star_gap_answers.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::gap_questions;

namespace {

uncertain_bool ask_segment(const question& q) {
  return segment_shows_edge(q.v, q.w, q.x, q.y) ? uncertain_bool(true) : uncertain_bool();
}

}  // namespace

TEST_CASE("an edge that its segment shows is one, in every family of input", "[segment_witness]") {
  for (const family& f : families) {
    DYNAMIC_SECTION(f.name) {
      sequence random{31};
      int shown = 0;
      for (int k = 0; k < 3000; ++k) {
        const std::uint64_t replay = random.state();
        const auto q = draw(f, random);
        if (!q) continue;
        const uncertain_bool answer = ask_segment(*q);
        shown += answer.certain();
        check_right(*q, answer, replay);
        CHECK(answer.certain() == segment_shows_edge(q->w, q->v, q->y, q->x));
      }
      CHECK((f.behind || shown > 10));
    }
  }
}

TEST_CASE("an edge that its segment just shows is one", "[segment_witness]") {
  for (const family& f : families) {
    if (f.grid) continue;
    DYNAMIC_SECTION(f.name) {
      sequence random{32};
      int shown = 0;
      for (int k = 0; k < 300; ++k) {
        const std::uint64_t replay = random.state();
        const auto drawn = draw(f, random);
        if (!drawn) continue;
        const question q = moved_to_border(
            *drawn, 0.05, 4, [](const question& moved) { return ask_segment(moved).certain(); });
        const uncertain_bool answer = ask_segment(q);
        shown += answer.certain();
        check_right(q, answer, replay);
      }
      CHECK((f.behind || shown > 10));
    }
  }
}

TEST_CASE("rounding modes and flushing leave what a segment shows right",
          "[segment_witness][environment]") {
  sequence random{33};
  int shown = 0;
  for (int k = 0; k < 4000; ++k) {
    const std::uint64_t replay = random.state();
    const auto q = draw(families[static_cast<std::size_t>(k) % std::size(families)], random);
    if (!q) continue;
    const bool flush = random.integer(0, 1) == 1;
    const auto round = static_cast<std::size_t>(k) / std::size(families);
    const uncertain_bool answer = [&] {
      const hostile_environment scope(directed_modes[round % 3], flush);
      return ask_segment(*q);
    }();
    shown += answer.certain();
    check_right(*q, answer, replay);
  }
  CHECK(shown > 500);
}

TEST_CASE("scaled by powers of two a segment is right or silent", "[segment_witness][range]") {
  sequence random{34};
  const auto scaled = [](site s, int length, int metric) {
    s.position = {std::ldexp(s.position.x, length), std::ldexp(s.position.y, length)};
    s.metric = {std::ldexp(s.metric.m11, metric), std::ldexp(s.metric.m12, metric),
                std::ldexp(s.metric.m22, metric)};
    return s;
  };
  int shown = 0;
  for (int k = 0; k < 600; ++k) {
    const auto q = draw(families[2], random);
    if (!q) continue;
    const bool expected = second_route(*q);
    for (const int length : {-1000, -400, -181, -60, 60, 90, 179, 400, 1000})
      for (const int metric : {-400, -140, -50, 50, 140, 400})
        if (segment_shows_edge(scaled(q->v, length, metric), scaled(q->w, length, metric),
                               scaled(q->x, length, metric), scaled(q->y, length, metric))) {
          ++shown;
          CHECK(expected);
        }
  }
  CHECK(shown > 100);
}

// A rhombus of two equilateral triangles. Each site is moved by up to a tenth of an edge.
TEST_CASE("on smooth input a segment shows most edges", "[segment_witness][tiers]") {
  for (const double condition : {1.0, 1e4, 1e6}) {
    sequence random{35};
    int asked = 0, shown = 0;
    for (int k = 0; k < 2000; ++k) {
      const metric_tensor base = stretched(condition, random.real(-4, 4));
      const double start = random.real(-4, 4);
      const auto at = [&](double length, double angle) {
        const auto u = round_off(base, length + random.real(-0.1, 0.1), start + angle);
        return site{{u.x, u.y}, changed(base, 0.05, random)};
      };
      constexpr double sixth = std::numbers::pi / 3;
      ++asked;
      shown += segment_shows_edge(at(0, 0), at(1, 0), at(1, sixth), at(1, -sixth));
    }
    INFO("condition " << condition << ": " << shown << " of " << asked);
    CHECK(shown >= 0.98 * asked);
  }
}
