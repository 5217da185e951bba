// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/mesh_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism {
using namespace internal;
namespace {

// Sums over triangles and their edges. Interior edges occur in two triangles, boundary edges in
// one, so that the latter are added once more.
struct sums {
  double half_edges = 0, unit = 0, lengths = 0;
  double quality = 0, least_quality = 1;
  double below_20 = 0, below_30 = 0;
  double area = 0, sigma = 0, eps = 0;

  void add(const sums& other) {
    half_edges += other.half_edges;
    unit += other.unit;
    lengths += other.lengths;
    quality += other.quality;
    least_quality = std::min(least_quality, other.least_quality);
    below_20 += other.below_20;
    below_30 += other.below_30;
    area += other.area;
    sigma = std::max(sigma, other.sigma);
    eps = std::max(eps, other.eps);
  }
};

// True if variation(p, q) of two sites whose distance is at least `shorter` in both metrics is
// certainly no more than sigma. That is so if tau^2 is at most T^2 = 1 / (1 - sigma shorter)^2,
// hence if T^2 is beyond both roots of det(M_q - x M_p), and of det(M_p - x M_q). The margin is far
// above the rounding errors of distortion(); pairs beyond it are computed.
bool varies_no_faster(const metric_tensor& p, const metric_tensor& q, double shorter,
                      double sigma) {
  constexpr double margin = 0x1p-36;
  const double inverse = 1 - sigma * shorter;
  if (!(inverse > margin)) return false;
  const double square = 1 / (inverse * inverse), product_p = p.m11 * p.m22,
               product_q = q.m11 * q.m22, mixed = p.m12 * q.m12;
  const double det_p = product_p - p.m12 * p.m12, det_q = product_q - q.m12 * q.m12;
  const double of_both = p.m22 * q.m11 + p.m11 * q.m22, trace = of_both - 2 * mixed;
  const auto is_beyond = [&](double first, double product, double last, double other_product) {
    const double scaled = first * square;
    const double size = (product * square + of_both) * square + other_product;
    return 2 * scaled > trace && (scaled - trace) * square + last > margin * size;
  };
  return is_beyond(det_p, product_p, det_q, product_q) &&
         is_beyond(det_q, product_q, det_p, product_p);
}

// Returns variation(p, q), given the shorter of both ends' distances.
double variation_over(const site& p, const site& q, double shorter) {
  const double tau = distortion(p.metric, q.metric);
  if (tau == 1) return 0;  // also where lengths overflow
  return (1 - 1 / tau) / shorter;
}

// Measures an edge once where both ends have the same metric, bit for bit.
void add_edge(const site& p, const site& q, sums& s) {
  const bool is_one = identical(p.metric, q.metric);
  const double by_p = metric_distance(p, q.position),
               by_q = is_one ? by_p : metric_distance(q, p.position);
  const double length = is_one ? by_p : (by_p + by_q) / 2, shorter = std::min(by_p, by_q);
  s.half_edges += 1;
  s.lengths += length;
  if (is_unit_length(length)) s.unit += 1;
  // Skips the variation where it is 0: with one metric whose lengths are finite and positive.
  const bool is_even = is_one && length > 0 && length < std::numeric_limits<double>::infinity() &&
                       p.metric.m11 + p.metric.m22 > 0;
  if (!is_even && !varies_no_faster(p.metric, q.metric, shorter, s.sigma))
    s.sigma = std::max(s.sigma, variation_over(p, q, shorter));
}

// Measures a triangle in coordinates in which its metrics are round.
triangle_shape shape_in_round(const triangle_sites& t) {
  metric_tensor mean{};
  double squares = 0;
  for (const site& s : t) {
    mean.m11 += s.metric.m11 / 3;
    mean.m12 += s.metric.m12 / 3;
    mean.m22 += s.metric.m22 / 3;
  }
  for (std::size_t i = 0; i < 3; ++i)
    squares += squared_distance({t[i].position, mean}, t[(i + 1) % 3].position);
  const point &a = t[0].position, &b = t[1].position, &c = t[2].position;
  const double plane = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  const double area = plane * root_of_determinant(mean);
  return {area, 4 * std::numbers::sqrt3 * area / squares};
}

using low_angles = std::array<angle_threshold, 2>;

void add_triangle(const triangle_sites& given, const low_angles& thresholds, sums& s) {
  const triangle_sites t = in_round_coordinates(given);
  for (std::size_t i = 0; i < 3; ++i) add_edge(t[i], t[(i + 1) % 3], s);
  const auto [area, quality] = shape_in_round(t);
  const auto [below_20, below_30] = smallest_angle_is_below(t, thresholds);
  s.quality += quality;
  s.least_quality = std::min(s.least_quality, quality);
  s.below_20 += below_20 ? 1 : 0;
  s.below_30 += below_30 ? 1 : 0;
  s.area += area;
  s.eps = std::max(s.eps, circumradius_in_round(t));
}

// Sums chunk by chunk, so that the results are the same for any number of threads.
sums sums_over(const mesh& m) {
  constexpr std::size_t chunk = 1024;
  const low_angles thresholds = {angle_threshold(20), angle_threshold(30)};
  const auto parts = collect_chunks<sums>(
      m.triangles.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<sums>& out) {
        out.emplace_back();
        for (std::size_t i = begin; i < end; ++i) {
          if (i + triangles_ahead < end)
            for (const vertex_index v : m.triangles[i + triangles_ahead]) prefetch(&m.sites[v]);
          const triangle& t = m.triangles[i];
          add_triangle({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]}, thresholds, out.back());
        }
      });
  sums all;
  for (const boundary_edge& e : m.boundary)
    if (!e.internal) add_edge(m.sites[e.a], m.sites[e.b], all);
  for (const sums& s : parts) all.add(s);
  return all;
}

// Divides the sums by the numbers of edges and triangles, for means and shares. Does not set the
// greatest aspect of the sites.
mesh_statistics means_of(const sums& all, std::size_t triangles) {
  const auto count = static_cast<double>(triangles);
  mesh_statistics result;
  result.edges = static_cast<std::size_t>(all.half_edges / 2);
  result.unit_edges = all.unit / all.half_edges;
  result.mean_length = all.lengths / all.half_edges;
  result.mean_quality = all.quality / count;
  result.least_quality = all.least_quality;
  result.below_20 = all.below_20 / count;
  result.below_30 = all.below_30 / count;
  result.metric_area = all.area;
  result.count_ratio = count / (all.area * 4 / std::numbers::sqrt3);
  result.sigma = all.sigma;
  result.eps = all.eps;
  result.sigma_eps = all.sigma * all.eps;
  return result;
}

}  // namespace

// Uses that the eigenvalues of M_p^-1 M_q are t +- sqrt(t^2 - d), t half the trace, d the
// determinant. Both tensors are first scaled by one power of two, which changes no ratio, as
// products of entries beyond 2^+-512 would leave the range of doubles; and a thin p is made round.
// Equal tensors skip that, as it would lose the smaller entry of one like diag(1e200, 1e-200).
double distortion(const metric_tensor& p, const metric_tensor& q) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double trace = p.m11 + p.m22;
  if (!(trace > 0 && std::isfinite(trace))) return infinity;
  if (identical(p, q)) return 1;
  constexpr double ordinary = 0x1p200;
  const double other = q.m11 + q.m22;
  const bool is_ordinary =
      std::max(trace, other) < ordinary && std::min(trace, other) * ordinary > 1;
  const int exponent = is_ordinary ? 0 : -std::ilogb(trace);
  const auto scaled = [exponent](const metric_tensor& m) {
    return metric_tensor{std::scalbn(m.m11, exponent), std::scalbn(m.m12, exponent),
                         std::scalbn(m.m22, exponent)};
  };
  metric_tensor a = is_ordinary ? p : scaled(p), b = is_ordinary ? q : scaled(q);
  if (is_thin(a)) {
    const round_coordinates round({}, a);
    a = round.inward({{}, a}).metric;
    b = round.inward({{}, b}).metric;
  }
  const double det_a = a.m11 * a.m22 - a.m12 * a.m12, det_b = b.m11 * b.m22 - b.m12 * b.m12;
  const double t = (a.m22 * b.m11 - 2 * a.m12 * b.m12 + a.m11 * b.m22) / det_a / 2;
  const double d = det_b / det_a;
  const double largest = t + std::sqrt(std::max(0.0, t * t - d));
  if (!(largest > 0 && d > 0)) return infinity;
  return std::sqrt(std::max({1.0, largest, largest / d}));
}

double variation(const site& p, const site& q) {
  return variation_over(p, q,
                        std::min(metric_distance(p, q.position), metric_distance(q, p.position)));
}

// Returns length over width of the unit circle: the root of the ratio of the eigenvalues t +- r, as
// (t + r) / root of the determinant.
double aspect(const metric_tensor& m) {
  const double r = elementary::hypot(m.m11 / 2 - m.m22 / 2, m.m12);
  return (m.m11 / 2 + m.m22 / 2 + r) / root_of_determinant(m);
}

triangle_shape shape_of(const triangle_sites& t) { return shape_in_round(in_round_coordinates(t)); }

std::map<std::string, double> by_name(const mesh_statistics& s) {
  return {{"edges", static_cast<double>(s.edges)},
          {"unit_edges", s.unit_edges},
          {"mean_length", s.mean_length},
          {"mean_quality", s.mean_quality},
          {"least_quality", s.least_quality},
          {"below_20", s.below_20},
          {"below_30", s.below_30},
          {"metric_area", s.metric_area},
          {"count_ratio", s.count_ratio},
          {"aspect", s.aspect},
          {"sigma", s.sigma},
          {"eps", s.eps},
          {"sigma_eps", s.sigma_eps}};
}

mesh_statistics measure(const mesh& m) {
  if (m.triangles.empty()) return {};
  mesh_statistics measured = means_of(sums_over(m), m.triangles.size());
  constexpr std::size_t sites_at_once = 4096;  // for a thread
  const auto greatest_of = [&m](std::size_t begin, std::size_t end) {
    double greatest = 0;
    for (std::size_t v = begin; v < end; ++v)
      greatest = std::max(greatest, aspect(m.sites[v].metric));
    return greatest;
  };
  for (const double of_chunk : map_chunks<double>(m.sites.size(), sites_at_once, greatest_of))
    measured.aspect = std::max(measured.aspect, of_chunk);
  return measured;
}

}  // namespace asterism
