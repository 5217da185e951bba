// SPDX-License-Identifier: MIT
//
// Questions about one gap of a star, drawn from families that are hard in different ways.
#pragma once

#include <array>
#include <cfenv>
#include <cmath>
#include <numbers>
#include <optional>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/random.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"

namespace asterism::gap_questions {
using namespace internal;

using sequence = splitmix64;

// Returns the tensor with eigenvalues 1 and `condition`; the first's direction is `angle`.
inline metric_tensor stretched(double condition, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c + condition * (s * s), (1 - condition) * (c * s), s * s + condition * (c * c)};
}

// Returns the displacement of this length and angle in the frame in which m is round.
inline displacement<double> round_off(const metric_tensor& m, double length, double angle) {
  const double a = std::sqrt(m.m11), b = m.m12 / a, c = std::sqrt(m.m22 - b * b);
  const double y = length * std::sin(angle) / c;
  return {(length * std::cos(angle) - b * y) / a, y};
}

// Returns a tensor near m: in the frame in which m is the identity it differs from that by about
// `change`.
inline metric_tensor changed(const metric_tensor& m, double change, sequence& random) {
  const double a = std::sqrt(m.m11), b = m.m12 / a, c = std::sqrt(m.m22 - b * b);
  const double p = std::exp(change * random.real(-1, 1)), r = std::exp(change * random.real(-1, 1)),
               q = random.real(-0.5, 0.5) * std::fmin(change, 1.0) * std::sqrt(p * r);
  return {a * a * p, a * b * p + a * c * q, b * b * p + 2 * b * c * q + c * c * r};
}

struct question {
  site v, w, y, x;  // w between y and x, counter-clockwise
};

struct family {
  const char* name;
  double most_condition = 10;  // the least is 1; powers of ten
  double least_change = 1e-6, most_change = 3;
  double offset = 0;
  bool grid = false, nearly_flat = false, far_neighbour = false;
  bool behind = false;     // w is behind a neighbour, up to a little more than twice as far
  bool unrelated = false;  // every metric is stretched in a direction of its own
};

inline constexpr family families[] = {
    {"any change of metric"},
    {"ill-conditioned", 1e12, 1e-3, 1},
    {"smooth", 1e3, 1e-6, 0.05},
    {"one metric but for rounding", 1e6, 1e-17, 1e-15},
    {"offset 1e8", 10, 1e-3, 0.1, 1e8},
    {"grid", 1, 0, 0, 0, true},
    {"gap near half a turn", 1e4, 1e-6, 0.3, 0, false, true},
    {"one far neighbour", 10, 1e-6, 0.3, 0, false, false, true},
    {"behind a neighbour", 1e6, 0.05, 1.5, 0, false, false, false, true},
    {"behind, ill-conditioned", 1e12, 1e-3, 0.3, 0, false, false, false, true},
    {"unrelated thin metrics", 1e6, 1e-3, 1, 0, false, false, false, false, true}};

inline double power(sequence& random, double low, double high) {
  return low > 0 ? std::exp(random.real(std::log(low), std::log(high))) : 0;
}

inline std::optional<question> draw(const family& f, sequence& random) {
  const metric_tensor base = stretched(power(random, 1, f.most_condition), random.real(-4, 4));
  const double change = power(random, f.least_change, f.most_change);
  const point centre{f.offset * random.real(-1, 1), f.offset * random.real(-1, 1)};
  const double start = random.real(-4, 4);
  const double gap = f.nearly_flat
                         ? std::numbers::pi - power(random, 1e-9, 1e-1) * random.real(-0.2, 1)
                         : random.real(0.3, 3.1);
  const auto at = [&](double length, double angle) {
    auto u = round_off(base, length, angle);
    metric_tensor m = changed(base, change, random);
    if (f.unrelated) m = stretched(power(random, 1, f.most_condition), random.real(-4, 4));
    if (f.grid) {
      u = {static_cast<double>(random.integer(-4, 4)), static_cast<double>(random.integer(-4, 4))};
      m = {1.0 + random.integer(0, 2), 0.5 * random.integer(-1, 1), 1.0 + random.integer(0, 2)};
    }
    return site{{centre.x + u.x, centre.y + u.y}, m};
  };
  const double reach = f.far_neighbour ? power(random, 1e-3, 1e4) : random.real(0.5, 2);
  question q{at(0, 0), at(power(random, 0.2, 4), start + gap * random.real(0, 1)),
             at(random.real(0.5, 2), start), at(reach, start + gap)};
  if (f.behind) {
    const bool behind_x = random.integer(0, 1) == 1;
    const double aside = power(random, 1e-9, 0.6);
    q.x = at(1, start + gap);
    q.y = at(1, start);
    q.w = at(random.real(1, 2.2), behind_x ? start + gap - aside : start + aside);
  }
  const auto w = between(q.v.position, q.w.position);
  if (cross(between(q.v.position, q.y.position), w) <= 0 ||
      cross(w, between(q.v.position, q.x.position)) <= 0)
    return std::nullopt;
  return q;
}

// Answers by intervals, or else by exact numbers: neither shares code with star_gap.
inline bool second_route(const question& q) {
  const uncertain_bool answer = interval_kernel().edge_test(q.v, q.w, q.x, q.y);
  return answer.certain() ? answer.value() : exact_kernel().edge_test(q.v, q.w, q.x, q.y);
}

// Moves w along its ray to the last place where `is_known` is true of the question. It is true at
// `known` times w's distance, and false at `unknown` times.
template <class IsKnown>
question moved_to_border(const question& q, double known, double unknown, const IsKnown& is_known) {
  const auto d = between(q.v.position, q.w.position);
  const auto at = [&](double factor) {
    question moved = q;
    moved.w.position = {q.v.position.x + factor * d.x, q.v.position.y + factor * d.y};
    return moved;
  };
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = std::sqrt(known * unknown);
    (is_known(at(middle)) ? known : unknown) = middle;
  }
  return at(known);
}

// Sets a rounding mode, and flushing of subnormal numbers if asked for, during its
// lifetime.
class hostile_environment {
 public:
  hostile_environment(int mode, [[maybe_unused]] bool flush) {
#if defined(__SSE2__)
    if (flush) _mm_setcsr(before_ | 0x8040U);
#endif
    std::fesetround(mode);
  }
  ~hostile_environment() {
#if defined(__SSE2__)
    _mm_setcsr(before_);
#endif
    std::fesetround(FE_TONEAREST);
  }
  hostile_environment(const hostile_environment&) = delete;
  hostile_environment& operator=(const hostile_environment&) = delete;

 private:
#if defined(__SSE2__)
  unsigned before_ = _mm_getcsr();
#endif
};

inline constexpr std::array directed_modes = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

}  // namespace asterism::gap_questions
