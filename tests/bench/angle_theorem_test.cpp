// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/theorem_table.hpp"
#include "branch_and_bound.hpp"

namespace {

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::angle_theorem;
namespace theorem = asterism::internal::theorem;

struct vector {
  double x = 0, y = 0;
};
vector operator-(const vector& a, const vector& b) { return {a.x - b.x, a.y - b.y}; }
double inner(const vector& a, const vector& b) { return a.x * b.x + a.y * b.y; }
double cross(const vector& a, const vector& b) { return a.x * b.y - a.y * b.x; }

double inner(const metric_tensor& m, const vector& a, const vector& b) {
  return m.m11 * a.x * b.x + m.m12 * (a.x * b.y + a.y * b.x) + m.m22 * a.y * b.y;
}
double length(const metric_tensor& m, const vector& a) { return std::sqrt(inner(m, a, a)); }

double distortion(const metric_tensor& p, const metric_tensor& q) {
  const double dp = p.m11 * p.m22 - p.m12 * p.m12, dq = q.m11 * q.m22 - q.m12 * q.m12;
  const double half = (p.m22 * q.m11 - 2 * p.m12 * q.m12 + p.m11 * q.m22) / dp / 2;
  const double greatest = half + std::sqrt(std::max(0.0, half * half - dq / dp));
  return std::sqrt(std::max({1.0, greatest, greatest * dp / dq}));
}

// Holds three sites, each at distance 1 from the origin in its own metric. The first is a, at which
// the angle is bounded.
struct configuration {
  std::array<vector, 3> at;
  std::array<metric_tensor, 3> metric;
};

class random_configurations {
 public:
  random_configurations(double variation, double ratio) : s_(variation), ratio_(ratio) {}

  // Draws a configuration that meets the hypotheses of the theorem.
  configuration next() {
    while (true) {
      const configuration c = any();
      if (is_allowed(c)) return c;
    }
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(draw_() >> 11) * 0x1p-53;
  }

  // Often draws values at the limits of the hypotheses, where the bound is nearest to being
  // exceeded.
  double eigenvalue() {
    const double most = -2 * std::log(1 - s_);
    const double kind = uniform(0, 3);
    return std::exp(kind < 1 ? most : kind < 2 ? -most : uniform(-most, most));
  }

  configuration any() {
    configuration c;
    for (int i = 0; i < 3; ++i) {
      const double t = uniform(0, std::numbers::pi), e = eigenvalue(), f = eigenvalue();
      const double x = std::cos(t), y = std::sin(t);
      c.metric[i] = {x * x * e + y * y * f, x * y * (e - f), y * y * e + x * x * f};
      const double direction = uniform(0, 2 * std::numbers::pi);
      const vector u{std::cos(direction), std::sin(direction)};
      const double r = 1 / length(c.metric[i], u);
      c.at[i] = {r * u.x, r * u.y};
    }
    return c;
  }

  bool is_allowed(const configuration& c) const {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) {
        const vector e = c.at[i] - c.at[j];
        const double first = length(c.metric[i], e), second = length(c.metric[j], e);
        if (std::max(first, second) < 1 / ratio_) return false;
        if (distortion(c.metric[i], c.metric[j]) * (1 - s_ * std::min(first, second)) > 1)
          return false;
      }
    return true;
  }

  double s_, ratio_;
  std::mt19937_64 draw_{7};
};

// Maps the configuration so that a's metric is round, the common point is the origin and a is at
// (-1, 0): the proof divides these configurations into boxes.
std::array<vector, 2> as_first_sees(const configuration& c) {
  const metric_tensor& m = c.metric[0];
  const double a = std::sqrt(m.m11), b = m.m12 / a, d = std::sqrt(m.m22 - b * b);
  const auto into_frame = [&](const vector& p) { return vector{a * p.x + b * p.y, d * p.y}; };
  const vector first = into_frame(c.at[0]);
  const auto turned = [&](const vector& p) {  // rotates so that the first site is at (-1, 0)
    const double size = std::sqrt(inner(first, first));
    const vector e{-first.x / size, -first.y / size};
    return vector{inner(p, e), cross(e, p)};
  };
  std::array<vector, 2> u{turned(into_frame(c.at[1])), turned(into_frame(c.at[2]))};
  // The proof leaves out mirror images.
  const vector origin{-1, 0};
  if (cross(u[0] - origin, u[1] - origin) < 0) std::swap(u[0], u[1]);
  if (u[0].y + u[1].y < 0) {
    std::swap(u[0], u[1]);
    u[0].y = -u[0].y;
    u[1].y = -u[1].y;
  }
  return u;
}

double smallest_angle(const std::array<vector, 2>& u) {
  const std::array<vector, 3> p{vector{-1, 0}, u[0], u[1]};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const vector a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
    least = std::min(least, std::atan2(std::abs(cross(a, b)), inner(a, b)));
  }
  return least * 180 / std::numbers::pi;
}

configuration_box box_around(const std::array<vector, 2>& u, double radius) {
  configuration_box box;
  for (int k = 0; k < 4; ++k) {
    const double x = k % 2 == 0 ? u[k / 2].x : u[k / 2].y;
    box.low[k] = x - radius;
    box.high[k] = x + radius;
  }
  return box;
}

[[gnu::noinline]] box_verdict judged(const configuration_box& box, const hypotheses& given) {
  const floating_point_scope scope(rounding::upward);
  return judge(box, given);
}

}  // namespace

TEST_CASE("twenty degrees are proved where the program's theorem needs them") {
  CHECK(prove(make_hypotheses(0.052, 1, 20), 1'000'000).proved);
  CHECK(prove(make_hypotheses(0.058, 1, 21), 1'000'000).proved);
  CHECK(prove(make_hypotheses(0.068, 1, 20), 1'000'000).proved);
}

TEST_CASE("every angle of the table is proved") {
  for (std::size_t i = 0; i < theorem::variations.size(); ++i)
    for (std::size_t k = 0; k < theorem::ratios.size(); ++k) {
      const double variation = theorem::variations[i], ratio = theorem::ratios[k],
                   degrees = theorem::proved_angles[i][k];
      INFO(degrees << " degrees at sigma R " << variation << ", R / lambda " << ratio);
      CHECK(prove(make_hypotheses(variation, ratio, degrees), 3'000'000).proved);
    }
}

TEST_CASE("angles that configurations are known to fall below are not proved") {
  // bench/worst_net_angle.py finds 24.82, 21.96 and 17.79 degrees.
  CHECK_FALSE(prove(make_hypotheses(0.052, 1, 25), 1'000'000).proved);
  CHECK_FALSE(prove(make_hypotheses(0.08, 1, 22), 1'000'000).proved);
  CHECK_FALSE(prove(make_hypotheses(0.113, 1, 18), 1'000'000).proved);
  // With equal metrics, an edge of the least length in the greatest circle has the least angle.
  CHECK_FALSE(prove(make_hypotheses(0, 1, 30.01), 1'000'000).proved);
  CHECK_FALSE(prove(make_hypotheses(0, 1.25, 23.58), 1'000'000).proved);
}

TEST_CASE("a proof that may judge too few boxes is no proof") {
  const proof_attempt attempt = prove(make_hypotheses(0.052, 1, 20), 100);
  CHECK_FALSE(attempt.proved);
  CHECK(attempt.boxes == 100);
}

TEST_CASE("no box around a configuration that the hypotheses allow is excluded") {
  for (const auto& [variation, ratio] :
       {std::pair{0.03, 1.0}, {0.068, 1.0}, {0.113, 1.0}, {0.052, 1.2}, {0.08, 1.5}}) {
    random_configurations configurations(variation, ratio);
    for (int k = 0; k < 4000; ++k) {
      const std::array<vector, 2> u = as_first_sees(configurations.next());
      const double angle = smallest_angle(u);
      INFO("sigma R " << variation << ", ratio " << ratio << ", configuration " << k << ": u "
                      << u[0].x << ' ' << u[0].y << ", v " << u[1].x << ' ' << u[1].y);
      for (const double radius : {1e-12, 1e-6, 1e-3}) {
        const configuration_box box = box_around(u, radius);
        if (angle < 59.9) {
          const hypotheses above = make_hypotheses(variation, ratio, angle + 0.01);
          CHECK(judged(box, above) == box_verdict::undecided);
        }
        CHECK(judged(box, make_hypotheses(variation, ratio, angle * 0.9)) != box_verdict::excluded);
      }
      const hypotheses below = make_hypotheses(variation, ratio, angle - 0.01);
      CHECK(judged(box_around(u, 1e-9), below) == box_verdict::angles_hold);
    }
  }
}

TEST_CASE("the bound of a length through the metric is met by metrics and by none exceeded") {
  // Checks that a box excluded because a site would be too near contains no valid configuration:
  // takes the same configurations, with one site moved towards another until they are too near.
  random_configurations configurations(0.068, 1);
  for (int k = 0; k < 2000; ++k) {
    configuration c = configurations.next();
    std::array<vector, 2> u = as_first_sees(c);
    u[1] = {u[0].x + 1e-3, u[0].y};
    CHECK(judged(box_around(u, 1e-9), make_hypotheses(0.068, 1, 20)) == box_verdict::excluded);
  }
}
