// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/surface_chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/surface/few_bits.hpp"

namespace asterism::internal {
namespace {

constexpr int samples = 16;  // of the lengths of a chart, in each direction

double length(const plain_vector& a) { return std::sqrt(dot(a, a)); }

// Converts derivatives to units of the patch's parameters.
plain_second_jet by_parameters(plain_second_jet j, double width, double height) {
  j.first.by_s = (1 / width) * j.first.by_s;
  j.first.by_t = (1 / height) * j.first.by_t;
  j.by_ss = (1 / width / width) * j.by_ss;
  j.by_st = (1 / width / height) * j.by_st;
  j.by_tt = (1 / height / height) * j.by_tt;
  return j;
}

struct principal {
  double first = 0, second = 0;  // moduli of the curvatures
  // Covectors that measure displacements of the chart along the two directions of curvature.
  std::array<std::array<double, 2>, 2> covector{};
};

// Returns the principal curvatures, of the first form g and the second b: with g = L L^T they are
// the eigenvalues of L^-1 b L^-T, and the covectors are L times its eigenvectors.
std::optional<principal> principal_of(const plain_second_jet& j) {
  const plain_jet& f = j.first;
  const double g11 = dot(f.by_s, f.by_s), g12 = dot(f.by_s, f.by_t), g22 = dot(f.by_t, f.by_t);
  plain_vector n = cross(f.by_s, f.by_t);
  const double area = length(n);
  if (!(area > 1e-14 * (g11 + g22)) || !std::isfinite(area)) return std::nullopt;
  n = (1 / area) * n;
  const double b11 = dot(j.by_ss, n), b12 = dot(j.by_st, n), b22 = dot(j.by_tt, n);
  const double l11 = std::sqrt(g11), l21 = g12 / l11, l22 = area / l11;
  const double m11 = b11 / g11, m12 = (b12 - b11 * l21 / l11) / (l11 * l22),
               m22 = (b22 - 2 * b12 * l21 / l11 + b11 * (l21 / l11) * (l21 / l11)) / (l22 * l22);
  const double mean = (m11 + m22) / 2, half = (m11 - m22) / 2,
               radius = elementary::hypot(half, m12);
  double c = 1, s = 0;  // the eigenvector of mean + radius
  if (radius > 0) {
    c = half >= 0 ? radius + half : m12;
    s = half >= 0 ? m12 : radius - half;
    const double size = elementary::hypot(c, s);
    c = size > 0 ? c / size : 1, s = size > 0 ? s / size : 0;
  }
  principal p;
  p.first = std::abs(mean + radius), p.second = std::abs(mean - radius);
  p.covector = {{{l11 * c, l21 * c + l22 * s}, {-l11 * s, -l21 * s + l22 * c}}};
  if (!std::isfinite(p.first) || !std::isfinite(p.second)) return std::nullopt;
  return p;
}

// Returns the density that a curvature requires, the square of an inverse length. With the
// curvature k the greatest distance of a chord of length h from its curve is k h^2 / 8, and that of
// a triangle with three sides of length h from the surface is k h^2 / 6.
double density(double curvature, double chord, const surface_sizes& sizes) {
  constexpr double chord_share = 6;
  double d = curvature / (chord_share * chord);
  if (sizes.turn) d = std::max(d, (curvature / *sizes.turn) * (curvature / *sizes.turn));
  if (sizes.longest) d = std::max(d, 1 / (*sizes.longest * *sizes.longest));
  return d;
}

// Returns the densities of the stronger and of the weaker curvature. A triangle as narrow as the
// stronger curvature requires is tilted by the height of its long sides' arcs over its width, so
// that this height must be less than the width, however large the chord.
std::array<double, 2> densities(double stronger, double weaker, const surface_sizes& sizes) {
  constexpr double tilt = 0.25;  // 0.4 takes 1.1 to 1.5 times the vertices on the teapot's lips
  const double first = density(stronger, sizes.chord, sizes);
  const double height = first > 0 ? std::min(sizes.chord, tilt / std::sqrt(first)) : sizes.chord;
  return {first, density(weaker, height, sizes)};
}

// Rounds both directions, unless they are nearly parallel, as in a very oblique chart: rounding
// could make them parallel.
void round_covectors(std::array<std::array<double, 2>, 2>& covector) {
  constexpr double apart = 0x1p-10;
  std::array<double, 2> scale{};
  for (std::size_t k = 0; k < 2; ++k)
    scale[k] = std::max(std::abs(covector[k][0]), std::abs(covector[k][1]));
  const double area = covector[0][0] * covector[1][1] - covector[0][1] * covector[1][0];
  if (!(std::abs(area) > apart * scale[0] * scale[1])) return;
  for (std::size_t k = 0; k < 2; ++k)
    for (double& x : covector[k]) x = in_steps_of(x, scale[k]);
}

void add_square(metric_tensor& m, const std::array<double, 2>& covector, double factor) {
  m.m11 += factor * covector[0] * covector[0];
  m.m12 += factor * covector[0] * covector[1];
  m.m22 += factor * covector[1] * covector[1];
}

}  // namespace

surface_chart::surface_chart(const surface_patch& patch, const std::vector<bezier_piece>& pieces,
                             const patch_spans& spans)
    : pieces_(&pieces), spans_(&spans) {
  double by_u = 0, by_v = 0;
  const double u0 = spans.u.front(), v0 = spans.v.front(), width = spans.u.back() - u0,
               height = spans.v.back() - v0;
  low_ = {u0, v0}, high_ = {spans.u.back(), spans.v.back()};
  for (int i = 0; i < samples; ++i)
    for (int k = 0; k < samples; ++k) {
      const plain_second_jet j =
          jet_at({u0 + (i + 0.5) / samples * width, v0 + (k + 0.5) / samples * height});
      by_u += length(j.first.by_s);
      by_v += length(j.first.by_t);
    }
  scale_u_ = by_u > 0 ? std::ilogb(by_u / (samples * samples)) : 0;
  scale_v_ = by_v > 0 ? std::ilogb(by_v / (samples * samples)) : 0;
  low_ = {std::ldexp(low_.x, scale_u_), std::ldexp(low_.y, scale_v_)};
  high_ = {std::ldexp(high_.x, scale_u_), std::ldexp(high_.y, scale_v_)};
  if (!patch.loops.empty()) keep_to_loops(patch);
}

// Takes the box of the control points, which contain their curves.
void surface_chart::keep_to_loops(const surface_patch& patch) {
  const trim_point& first = patch.loops[0][0].control[0];
  double u0 = first.u, u1 = first.u, v0 = first.v, v1 = first.v;
  for (const trim_loop& loop : patch.loops)
    for (const trim_curve& c : loop)
      for (const trim_point& p : c.control) {
        u0 = std::min(u0, p.u), u1 = std::max(u1, p.u);
        v0 = std::min(v0, p.v), v1 = std::max(v1, p.v);
      }
  const point low = in_patch({std::ldexp(u0, scale_u_), std::ldexp(v0, scale_v_)}),
              high = in_patch({std::ldexp(u1, scale_u_), std::ldexp(v1, scale_v_)});
  if (low.x < high.x && low.y < high.y) low_ = low, high_ = high;
}

point surface_chart::in_patch(const point& p) const {
  const double u0 = std::ldexp(spans_->u.front(), scale_u_),
               u1 = std::ldexp(spans_->u.back(), scale_u_),
               v0 = std::ldexp(spans_->v.front(), scale_v_),
               v1 = std::ldexp(spans_->v.back(), scale_v_);
  return {std::clamp(p.x, u0, u1), std::clamp(p.y, v0, v1)};
}

surface_chart::local_place surface_chart::place_of(const point& p) const {
  const surface_place at =
      place_in(*pieces_, *spans_, std::ldexp(p.x, -scale_u_), std::ldexp(p.y, -scale_v_));
  return {&(*pieces_)[at.piece], at.s, at.t};
}

plain_second_jet surface_chart::jet_at(const point& p) const {
  const local_place at = place_of(p);
  const plain_second_jet j =
      by_parameters(evaluate_twice(*at.piece, at.s, at.t), at.piece->u_high - at.piece->u_low,
                    at.piece->v_high - at.piece->v_low);
  return by_parameters(j, std::ldexp(1, scale_u_), std::ldexp(1, scale_v_));
}

space_point surface_chart::lift(const point& p) const {
  const local_place at = place_of(p);
  const plain_vector q = evaluate(*at.piece, at.s, at.t).at;
  return {q.x, q.y, q.z};
}

surface_chart::local_metric surface_chart::metric_at(const point& p,
                                                     const surface_sizes& sizes) const {
  // Distance from a side, as a part of the width, at which the metric of a point without a normal
  // is taken: far enough for a normal to exist, near enough to represent the point.
  constexpr double inside = 1.0 / 256;
  const point wide{high_.x - low_.x, high_.y - low_.y};
  std::optional<principal> k = principal_of(jet_at(p));
  if (!k) {
    const point q{std::clamp(p.x, low_.x + inside * wide.x, high_.x - inside * wide.x),
                  std::clamp(p.y, low_.y + inside * wide.y, high_.y - inside * wide.y)};
    k = principal_of(jet_at(q));
  }
  local_metric m;
  if (!k) return m;
  m.known = true;
  m.densities = k->first >= k->second ? densities(k->first, k->second, sizes)
                                      : densities(k->second, k->first, sizes);
  if (k->first < k->second) std::swap(m.densities[0], m.densities[1]);
  for (double& d : m.densities) d = in_few_bits(d);
  round_covectors(k->covector);
  const auto& [a, b] = k->covector;
  const double area = a[0] * b[1] - a[1] * b[0];
  m.directions = {point{b[1] / area, -b[0] / area}, point{-a[1] / area, a[0] / area}};
  for (std::size_t i = 0; i < 2; ++i) add_square(m.metric, k->covector[i], m.densities[i]);
  return m;
}

}  // namespace asterism::internal
