// SPDX-License-Identifier: MIT
//
// Recomputes the error constants of star_gap: runs its formulas on a number that counts roundings
// and magnitudes, and compares its frame with exact arithmetic.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdint>

#include "asterism/core/dyadic.hpp"
#include "asterism/kernels/normal_frame.hpp"
#include "asterism/kernels/star_gap_formulas.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::star_gap_detail;

namespace {

// The greatest number of factors 1 + theta on a monomial, and the sum of the monomials' bounds.
struct counted {
  int depth = 0;
  double magnitude = 0;
  friend counted operator+(const counted& a, const counted& b) {
    return {std::max(a.depth, b.depth) + 1, a.magnitude + b.magnitude};
  }
  friend counted operator-(const counted& a, const counted& b) { return a + b; }
  friend counted operator*(const counted& a, const counted& b) {
    return {a.depth + b.depth + 1, a.magnitude * b.magnitude};
  }
  counted operator-() const { return *this; }
};

// Values that come out of the frame carry one theta; u, s and the doubles made from them do not.
struct sizes {
  double extent, trace, u, s, extent_x, trace_x;
};
basic_metric_tensor<counted> tensor(double trace) { return {{1, trace}, {1, trace}, {1, trace}}; }
displacement<counted> offset(double extent) { return {{1, extent}, {1, extent}}; }

// u is exact, and its two components together are its extent: the formulas only use sums of them.
displacement<counted> direction(double extent) { return {{0, extent / 2}, {0, extent / 2}}; }

constexpr sizes all_sizes[] = {{1, 1, 1, 1, 1, 1},        {0.25, 2, 3, 0.5, 2, 2},
                               {7, 0.1, 0.01, 3, 5, 40},  {1e-9, 2, 1e-5, 1, 3e-4, 2},
                               {1e7, 30, 2, 0.1, 1, 1},   {3, 2, 1e9, 1e-3, 1e6, 0.3},
                               {0.5, 1e7, 1, 40, 2, 1e-6}};

}  // namespace

TEST_CASE("depths and magnitudes of the gap's bounds are those of the formulas", "[star_gap]") {
  for (const sizes& z : all_sizes) {
    const auto n = tensor(z.trace), n_x = tensor(z.trace_x);
    const auto d = offset(z.extent), d_x = offset(z.extent_x), u = direction(z.u);
    const counted s{0, z.s}, u_squared = dot(u, u);
    // Adds a depth of one for the magnitude's own rounding and the terms of second order.
    const ray_equation<counted> ray(n, d, apply(n, d), u, u_squared);
    const counted at_s = ray.at(s), discriminant = ray.discriminant();
    const counted convex = convexity(ray.c, {1, z.trace * z.trace}, d);
    const counted steep =
        steepness_towards(s, d, dot(d_x, apply(n_x, d_x)), u_squared - dot(u, apply(n_x, u)),
                          apply(n_x, d_x), apply(n_x, u));
    const counted turn = cross(d, d_x);
    CHECK(at_s.depth < ray_depth);
    CHECK(ray.c.depth < c_depth);
    CHECK(discriminant.depth < discriminant_depth);
    CHECK(convex.depth < convexity_depth);
    CHECK(steep.depth < steepness_depth);
    CHECK(turn.depth < cross_depth);
    // Radicands of the side conditions, for chosen `bend` and `step`.
    const counted own = radicand_on_ray(ray.c, {1, z.trace * z.trace}, d_x, turn);
    const counted bend{0, z.trace}, step{0, z.s};
    const counted beyond = radicand_beyond(d_x, d, turn, bend, step);
    CHECK(own.depth < side_condition_depth);
    CHECK(beyond.depth < side_condition_depth);
    const double rounded = 1 - 1e-12;
    CHECK(rounded * own.magnitude <= radicand_on_ray_magnitude(z.extent, z.trace, z.extent_x));
    CHECK(rounded * beyond.magnitude <=
          radicand_beyond_magnitude(z.extent_x, z.extent, z.trace, z.s));
    CHECK(rounded * at_s.magnitude <= ray_magnitude(z.s, z.extent, z.trace, z.u));
    CHECK(rounded * ray.c.magnitude <= c_magnitude(z.extent, z.trace));
    CHECK(rounded * discriminant.magnitude <= discriminant_magnitude(z.extent, z.trace, z.u));
    CHECK(rounded * convex.magnitude <= convexity_magnitude(z.extent, z.trace));
    CHECK(rounded * steep.magnitude <=
          steepness_magnitude(z.s, z.extent, z.extent_x, z.trace_x, z.u));
  }
}

// Comparisons of a gap at z + step n (docs/math/star-gap-errors.md, section 2). Quotients and roots
// count as ingredients and carry no rounding here.
TEST_CASE("no side condition carries more roundings than the tolerance has room for",
          "[star_gap]") {
  const auto d = offset(1), z = offset(1), u = direction(1), n_d = apply(tensor(1), d);
  const counted step{0, 1}, quotient{0, 1}, c = dot(d, n_d), turn = cross(d, z), determinant{1, 1},
                                            bend = determinant * quotient;
  const counted leant = quotient * (u.x + bend * cross(u, z) * z.y) + quotient * n_d.x;
  const displacement<counted> slope{leant, leant};
  const counted tangent = c * (step * dot(slope, d) + dot(slope, z));
  const counted rooted = c * (step * dot(slope, d) + (quotient + quotient));
  const counted top_at_z =
      dot(z, n_d) + quotient * (c * dot(u, z) + determinant * turn * cross(u, d));
  const counted at_end =
      dot(d, n_d) + cross(u, d) * quotient * convexity(c, determinant, d) + quotient;
  // C is known to within one ingredient, and counts as one where it is a factor.
  const int of_c = c.depth;
  const counted top = top_at_z + step * at_end;
  CHECK(tangent.depth - of_c + 1 < side_condition_depth);
  CHECK(rooted.depth - of_c + 1 < side_condition_depth);
  CHECK(top.depth + 1 < side_condition_depth);
  const counted room = quotient * (dot(d, d) - dot(d, z)) - at_end * turn;
  CHECK(room.depth < side_condition_depth);
  // Three ingredients and the roundings of these formulas are below a tolerance of eight
  // ingredients.
  constexpr double ingredient = 0x1p14;  // the least, in units of rho
  CHECK(3 * ingredient + side_condition_depth + 1 < 8 * ingredient);
}

// docs/math/star-gap-errors.md, section 1, step by step: relative errors in units of eps sigma,
// with sigma >= 1 and 2^-73 sigma^2 <= eps sigma.
TEST_CASE("the frame's error factor is that of its steps", "[star_gap]") {
  CHECK(0x1p-73 * 0x1p21 <= eps);
  constexpr double determinant_error = 4 + 1;
  constexpr double root = determinant_error / 2 + 1, inverse_root = root + 1,
                   inverse_determinant = 2 * inverse_root + 1;
  constexpr double shear = 1 + 1, stretch = root + 1 + 1;
  constexpr double first = std::max(1.0, shear + 1 + 1) + 1;  // dx + shear dy
  constexpr double second = stretch + 1 + 1;
  CHECK(first <= frame_error_factor);
  CHECK(second <= frame_error_factor);
  // The error of n12 is at most |beta m11| / root = sigma n11 / 2, and that of n12's own rounding.
  constexpr double n12_on_n11 = (shear + 1) / 2, n12_on_itself = 1 + inverse_root + 1;
  CHECK(n12_on_n11 + n12_on_itself / 2 <= frame_error_factor);
  // n22 = (n12^2 + Delta) / n11, |n12| at most half the trace.
  constexpr double square = 2 * n12_on_itself + 1, delta = 4 + inverse_determinant + 1;
  constexpr double on_itself = std::max(square, delta) + 1 + 1 + 3, on_trace = n12_on_n11 + 1;
  CHECK(on_itself + on_trace + 1 <= frame_error_factor);  // 1 for the terms of second order
  CHECK(delta / 4 + 1 <= frame_error_factor);             // the determinant itself
}

TEST_CASE("what is brought into the frame is off by less than its bound", "[star_gap]") {
  std::uint64_t state = 5;
  const auto real = [&](double low, double high) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * (static_cast<double>(state >> 11) * 0x1p-53);
  };
  const auto draw = [&](double condition, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return metric_tensor{c * c + condition * s * s, (1 - condition) * c * s,
                         s * s + condition * c * c};
  };
  const auto magnitude = [](const dyadic& x) { return x.sign_value() == sign::negative ? -x : x; };
  for (int k = 0; k < 4000; ++k) {
    const double condition = std::pow(10.0, real(0, 12)), angle = real(-4, 4);
    const site v{{real(-1, 1), real(-1, 1)}, draw(condition, angle)};
    const site z{{real(-1, 1), real(-1, 1)},
                 draw(condition * real(0.5, 2), angle + real(-1, 1) / std::sqrt(condition))};
    std::fesetround(std::array{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}[k % 4]);
    const normal_frame frame(v);
    const framed_site f = frame.bring(z);
    const double rho = frame.rho();
    std::fesetround(FE_TONEAREST);
    if (!frame.usable() || !normal_frame::in_range(f)) continue;

    // With a, b, c of v: a x' = a dx + b dy; (a y')^2 = D dy^2.
    const dyadic a(v.metric.m11), b(v.metric.m12), c(v.metric.m22), D = a * c - b * b;
    const dyadic dx = dyadic(z.position.x) - dyadic(v.position.x),
                 dy = dyadic(z.position.y) - dyadic(v.position.y);
    const dyadic off = dyadic(rho) * dyadic(f.extent);
    CHECK(magnitude(a * dyadic(f.offset.x) - (a * dx + b * dy)) < a * off);
    const dyadic y = magnitude(dyadic(f.offset.y)), y_low = y - off, y_high = y + off;
    CHECK(D * dy * dy < a * a * y_high * y_high);
    if (y_low.sign_value() == sign::positive) CHECK(a * a * y_low * y_low < D * dy * dy);

    // n11 = m11 / a; n12 = X / (a sqrt D), X = a m12 - b m11; n22 m11 D a = X^2 + a^2 det M_z.
    const dyadic m11(z.metric.m11), m12(z.metric.m12), m22(z.metric.m22);
    const dyadic X = a * m12 - b * m11, det = m11 * m22 - m12 * m12;
    const dyadic wide = dyadic(rho) * dyadic(f.trace);
    CHECK(magnitude(a * dyadic(f.metric.m11) - m11) < a * wide);
    const dyadic n12 = magnitude(dyadic(f.metric.m12)), high = n12 + wide, low = n12 - wide;
    CHECK(X * X < a * a * D * high * high);
    if (low.sign_value() == sign::positive) CHECK(a * a * D * low * low < X * X);
    const dyadic unit = m11 * D * a;
    CHECK(magnitude(unit * dyadic(f.metric.m22) - (X * X + a * a * det)) < unit * wide);
    CHECK(magnitude(D * dyadic(f.determinant) - det) < D * wide * dyadic(f.trace));
    CHECK(magnitude(dyadic(star_gap_detail::determinant(z.metric)) - det) <
          dyadic(4 * eps) * det + dyadic(0x1p-73) * m11 * m22);
  }
}
