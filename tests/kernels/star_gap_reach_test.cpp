// SPDX-License-Identifier: MIT
//
// The vertex of a gap and its reach, beyond which no site is accepted (lemma 4.3 of
// docs/math/certificate.md).
#include <algorithm>
#include <cmath>

#include "star_gap_answers.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::gap_questions;

namespace {

// The square root of the largest eigenvalue of M_w^-1 M_v, or 1 if that is more.
double greatest_stretch(const metric_tensor& v, const metric_tensor& w) {
  const double determinant = w.m11 * w.m22 - w.m12 * w.m12;
  const double half = 0.5 * (v.m11 * w.m22 - 2 * v.m12 * w.m12 + v.m22 * w.m11);
  const double product = (v.m11 * v.m22 - v.m12 * v.m12) * determinant;
  const double root = std::sqrt(std::fmax(half * half - product, 0));
  return std::sqrt(std::fmax((half + root) / determinant, 1));
}

double length_from(const site& v, const site& w) {
  return std::sqrt(squared_length(v.metric, between(v.position, w.position)));
}

}  // namespace

TEST_CASE("the vertex of a gap is equally far from all three", "[star_gap]") {
  sequence random{16};
  int found = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto q = draw(families[2], random);
    if (!q) continue;
    const star_gap gap(q->v, q->y, q->x);
    if (!gap.has_vertex()) continue;
    ++found;
    const auto distance = [&](const site& s) {
      return squared_length(s.metric, between(s.position, gap.vertex()));
    };
    const double expected = gap.vertex_distance_squared();
    for (const site& s : {q->v, q->x, q->y}) CHECK(distance(s) == Approx(expected).epsilon(1e-6));
  }
  CHECK(found > 500);
}

TEST_CASE("a far site of quite another metric is refused", "[star_gap]") {
  const metric_tensor round{1, 0, 1};
  const site v{{0, 0}, round}, y{{1, 0}, round}, x{{0.5, 0.875}, round};
  sequence random{18};
  int decided = 0;
  for (int k = 0; k < 500; ++k) {
    const double angle = random.real(0.1, 0.9), length = power(random, 3, 1e4);
    const question q{v,
                     {{length * std::cos(angle), length * std::sin(angle)},
                      stretched(power(random, 1, 30), random.real(-4, 4))},
                     y,
                     x};
    const uncertain_bool answer = ask(q);
    decided += answer.certainly(false);
    check_right(q, answer, static_cast<std::uint64_t>(k));
  }
  CHECK(decided >= 495);
}

// No site beyond the reach is accepted (lemma 4.3 of docs/math/certificate.md, with the gap's
// bounds).
TEST_CASE("beyond the reach of a gap nothing is accepted", "[star_gap]") {
  sequence random{17};
  int known = 0;
  for (int k = 0; k < 2000; ++k) {
    const std::uint64_t replay = random.state();
    const auto drawn = draw(families[2], random);
    if (!drawn) continue;
    question q = *drawn;
    const star_gap gap(q.v, q.y, q.x);
    if (!std::isfinite(gap.reach())) continue;
    ++known;
    CHECK(gap.reach() >= std::sqrt(gap.vertex_distance_squared()) * (1 - 1e-6));
    const double far = (1 + greatest_stretch(q.v.metric, q.w.metric)) * gap.reach();
    const auto d = between(q.v.position, q.w.position);
    const double factor = 1.0001 * far / std::sqrt(squared_length(q.v.metric, d));
    q.w.position = {q.v.position.x + factor * d.x, q.v.position.y + factor * d.y};
    INFO("replay: sequence{" << replay << "}");
    CHECK_FALSE(second_route(q));
  }
  CHECK(known > 500);
}

TEST_CASE("no accepted site is beyond the reach of its gap, and some are nearly as far",
          "[star_gap]") {
  double farthest = 0;
  for (const family& f : families) {
    if (f.grid) continue;
    sequence random{31};
    int accepted = 0;
    for (int k = 0; k < 4000; ++k) {
      const std::uint64_t replay = random.state();
      const auto q = draw(f, random);
      if (!q) continue;
      const star_gap gap(q->v, q->y, q->x);
      if (!std::isfinite(gap.reach()) || !second_route(*q)) continue;
      ++accepted;
      const double share = length_from(q->v, q->w) /
                           ((1 + greatest_stretch(q->v.metric, q->w.metric)) * gap.reach());
      INFO(f.name << ", replay: sequence{" << replay << "}");
      CHECK(share <= 1 + 1e-9);
      farthest = std::fmax(farthest, share);
    }
    CHECK(accepted > 100);
  }
  CHECK(farthest > 0.98);
}

// Recomputes the two terms of R besides the vertex's distance, with more digits and in another
// order.
TEST_CASE("the reach of a gap is that of its formula", "[star_gap]") {
  using wide = long double;
  const auto form = [](const metric_tensor& m, const displacement<wide>& a,
                       const displacement<wide>& b) {
    return m.m11 * a.x * b.x + m.m12 * (a.x * b.y + a.y * b.x) + m.m22 * a.y * b.y;
  };
  const auto determinant = [](const metric_tensor& m) {
    return wide(m.m11) * m.m22 - wide(m.m12) * m.m12;
  };
  const auto offset = [](const point& from, const point& to) {
    return displacement<wide>{wide(to.x) - from.x, wide(to.y) - from.y};
  };
  sequence random{32};
  int known = 0, convex = 0, by_edge = 0;
  for (int k = 0; k < 6000; ++k) {
    const std::uint64_t replay = random.state();
    const auto q = draw(families[k % 2 == 0 ? 0 : 7], random);
    if (!q) continue;
    const star_gap gap(q->v, q->y, q->x);
    if (!gap.has_vertex() || !std::isfinite(gap.reach())) continue;
    ++known;
    const metric_tensor& own = q->v.metric;
    const auto u = offset(q->v.position, gap.vertex());
    const wide radius = std::sqrt(form(own, u, u));
    wide reach = radius;
    for (const site* z : {&q->x, &q->y}) {
      const auto d = offset(q->v.position, z->position);
      const wide length = std::sqrt(form(own, d, d)), c = form(z->metric, d, d);
      const wide bend = determinant(z->metric) / c, turned = cross(u, d);
      wide bound = 1 + length / std::sqrt(c);
      if (bend * length * length < determinant(own)) {  // s_z is convex: its tangent at u
        ++convex;
        bound = 1 + form(own, u, d) / std::sqrt(c * (radius * radius - bend * turned * turned));
      }
      reach = std::max({reach, length / bound, length / 2});
    }
    by_edge += reach > 1.001L * radius;
    INFO("replay: sequence{" << replay << "}");
    CHECK(gap.reach() >= reach * (1 - 1e-8L));  // the vertex is correct to about ten digits
    CHECK(gap.reach() <= reach * (1 + 1e-3L));
  }
  CHECK(known > 1500);
  CHECK(convex > 300);
  CHECK(by_edge > 100);
}
