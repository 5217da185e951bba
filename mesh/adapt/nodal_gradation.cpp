// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/nodal_gradation.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::adapting {
namespace {

// Reduction of B as A = F^T F sees it: F = [f11 f12; 0 f22], the eigenvalues, and the eigenvectors
// (c, s), (-s, c).
struct reduction {
  double f11, f12, f22;
  double c, s, high, low;
};

reduction reduce(const metric_tensor& a, const metric_tensor& b) {
  reduction r{};
  r.f11 = std::sqrt(a.m11);
  r.f12 = a.m12 / r.f11;
  r.f22 = std::sqrt(std::max(std::fma(a.m11, a.m22, -a.m12 * a.m12), 0.0)) / r.f11;
  // G = F^-1 = [1/f11, -f12/(f11 f22); 0, 1/f22]; C = G^T B G.
  const double g11 = 1 / r.f11, g12 = -r.f12 / (r.f11 * r.f22), g22 = 1 / r.f22;
  const double c11 = g11 * g11 * b.m11, c12 = g11 * (g12 * b.m11 + g22 * b.m12),
               c22 = g12 * g12 * b.m11 + 2 * g12 * g22 * b.m12 + g22 * g22 * b.m22;
  const double half = (c11 - c22) / 2, radius = elementary::hypot(half, c12);
  r.high = (c11 + c22) / 2 + radius;
  const double determinant = std::max(std::fma(b.m11, b.m22, -b.m12 * b.m12), 0.0) /
                             std::max(std::fma(a.m11, a.m22, -a.m12 * a.m12), 0.0);
  r.low = determinant / r.high;
  double x = half >= 0 ? half + radius : c12, y = half >= 0 ? c12 : radius - half;
  const double length = elementary::hypot(x, y);
  r.c = length > 0 ? x / length : 1;
  r.s = length > 0 ? y / length : 0;
  return r;
}

// Returns F^T Q diag(high, low) Q^T F.
metric_tensor restore(const reduction& r, double high, double low) {
  const double d11 = high * r.c * r.c + low * r.s * r.s, d12 = (high - low) * r.c * r.s,
               d22 = high * r.s * r.s + low * r.c * r.c;
  return {r.f11 * r.f11 * d11, r.f11 * (r.f12 * d11 + r.f22 * d12),
          r.f12 * r.f12 * d11 + 2 * r.f12 * r.f22 * d12 + r.f22 * r.f22 * d22};
}

bool is_metric(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m22) && m.m11 > 0 &&
         std::fma(m.m11, m.m22, -m.m12 * m.m12) > 0;
}

double length(const metric_tensor& m, const point& d) {
  return std::sqrt(d.x * (m.m11 * d.x + 2 * m.m12 * d.y) + m.m22 * d.y * d.y);
}

// Returns the length of an edge in a metric that changes geometrically along it, from those its
// ends measure.
double logarithmic_mean(double a, double b) {
  const double ratio = a / b;
  return std::abs(ratio - 1) > 1e-3 ? (a - b) / elementary::log(ratio) : (a + b) / 2;
}

}  // namespace

double log_distortion(const metric_tensor& a, const metric_tensor& b) {
  const reduction r = reduce(a, b);
  return std::max(std::abs(elementary::log(r.high)), std::abs(elementary::log(r.low))) / 2;
}

bool make_alike(metric_tensor& a, metric_tensor& b, double most) {
  const reduction r = reduce(a, b);
  const double high = elementary::log(r.high), low = elementary::log(r.low);
  if (!(std::max(std::abs(high), std::abs(low)) > 2 * most)) return false;
  constexpr double aim = 0.98;  // of the limit, so that rounds do not creep up to it
  const auto share = [&](double logarithm) {
    const double size = std::abs(logarithm);
    return size > 2 * most ? (1 - aim * 2 * most / size) / 2 * logarithm : 0;
  };
  const double x = share(high), y = share(low);
  const metric_tensor at_a = restore(r, elementary::exp(x), elementary::exp(y)),
                      at_b = restore(r, elementary::exp(high - x), elementary::exp(low - y));
  if (!is_metric(at_a) || !is_metric(at_b)) return false;
  a = at_a;
  b = at_b;
  return true;
}

std::size_t grade(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                  const gradation_limit& limit, std::vector<metric_tensor>& tensors) {
  const double at_unit = elementary::log(limit.distortion);
  // Edges with an end that changed since they were looked at.
  std::vector<std::size_t> changed_in(places.size(), 1);
  for (std::size_t round = 1; round <= limit.most_rounds; ++round) {
    bool any = false;
    for (const graph_edge& e : edges) {
      if (changed_in[e.a] < round && changed_in[e.b] < round) continue;
      const point d{places[e.b].x - places[e.a].x, places[e.b].y - places[e.a].y};
      const double at_a = length(tensors[e.a], d), at_b = length(tensors[e.b], d);
      const double mean = logarithmic_mean(at_a, at_b) / limit.unit;
      const double most = at_unit * std::clamp(mean, limit.shortest, limit.longest);
      if (!make_alike(tensors[e.a], tensors[e.b], most)) continue;
      changed_in[e.a] = changed_in[e.b] = round + 1;
      any = true;
    }
    if (!any) return round;
  }
  return limit.most_rounds + 1;
}

}  // namespace asterism::internal::adapting
