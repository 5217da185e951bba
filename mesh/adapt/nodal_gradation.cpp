// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/nodal_gradation.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/quick_logarithm.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

bool is_metric(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m22) && m.m11 > 0 &&
         std::fma(m.m11, m.m22, -m.m12 * m.m12) > 0;
}

// True if the reduced pair is certainly within this limit. Uses |ln x| <= |x - 1| / root x, so that
// most pairs need no logarithm. False says nothing.
bool are_surely_alike(const simultaneous_reduction& r, double most) {
  constexpr double roundings = 1 - 1e-9;
  const auto is_within = [most](double ratio) {
    const double s = std::sqrt(ratio);
    return std::abs(s - 1) <= most * roundings * std::sqrt(s);
  };
  return is_within(r.high) && is_within(r.low);
}

bool make_alike_by(const simultaneous_reduction& r, double most, double coarser_part,
                   metric_tensor& a, metric_tensor& b) {
  const double high = quick_log(r.high), low = quick_log(r.low);
  if (!(std::max(std::abs(high), std::abs(low)) > 2 * most)) return false;
  // Part of the limit that a clipped pair is brought to, so that rounds do not creep up to the
  // limit. With halves the pair moves to the nearest pair within that part of the limit.
  constexpr double aim = 0.98;
  // Signed excess over the aim, and the part of it that a takes: a is the coarser side where b
  // measures more.
  const auto excess = [&](double logarithm) {
    const double size = std::abs(logarithm);
    return size > aim * 2 * most ? (1 - aim * 2 * most / size) * logarithm : 0;
  };
  const auto part = [&](double whole) {
    return whole * (whole > 0 ? coarser_part : 1 - coarser_part);
  };
  // Leaves what has no excess as it is.
  const auto times_exp = [](double value, double power) {
    return power == 0 ? value : value * quick_exp(power);
  };
  const double ex = excess(high), ey = excess(low), x = part(ex), y = part(ey);
  const metric_tensor at_a = restore(r, times_exp(1, x), times_exp(1, y)),
                      at_b = restore(r, times_exp(r.high, x - ex), times_exp(r.low, y - ey));
  if (!is_metric(at_a) || !is_metric(at_b)) return false;
  a = at_a;
  b = at_b;
  return true;
}

}  // namespace

double log_distortion(const metric_tensor& a, const metric_tensor& b) {
  const simultaneous_reduction r = reduce(a, b);
  return std::max(std::abs(quick_log(r.high)), std::abs(quick_log(r.low))) / 2;
}

double log_variation(const site& a, const site& b) {
  const point d{b.position.x - a.position.x, b.position.y - a.position.y};
  return log_distortion(a.metric, b.metric) /
         logarithmic_mean(plain_length(a.metric, d), plain_length(b.metric, d), quick_log);
}

bool make_alike(metric_tensor& a, metric_tensor& b, double most, double coarser_part) {
  const simultaneous_reduction r = reduce(a, b);
  return !are_surely_alike(r, most) && make_alike_by(r, most, coarser_part, a, b);
}

std::size_t grade(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                  const gradation_limit& limit, std::vector<metric_tensor>& tensors,
                  const cancellation& stop) {
  const double at_unit = elementary::log(limit.distortion);
  // Round from which an edge with this end has to be looked at again.
  std::vector<std::size_t> changed_in(places.size(), 1);
  for (std::size_t round = 1; round <= limit.most_rounds && !stop.is_requested(); ++round) {
    bool any = false;
    std::size_t pairs = 0;
    const double coarser_part = round <= limit.uneven_rounds ? limit.coarser_part : 0.5;
    for (const graph_edge& e : edges) {
      if (changed_in[e.a] < round && changed_in[e.b] < round) continue;
      ++pairs;
      const point d{places[e.b].x - places[e.a].x, places[e.b].y - places[e.a].y};
      const double at_a = plain_length(tensors[e.a], d), at_b = plain_length(tensors[e.b], d);
      const auto most_at = [&](double mean) {
        return at_unit * std::clamp(mean / limit.unit, limit.shortest, limit.longest);
      };
      // The geometric mean is less than the logarithmic one.
      const simultaneous_reduction r = reduce(tensors[e.a], tensors[e.b]);
      if (are_surely_alike(r, most_at(std::sqrt(at_a * at_b)))) continue;
      const double most = most_at(logarithmic_mean(at_a, at_b, quick_log));
      if (!make_alike_by(r, most, coarser_part, tensors[e.a], tensors[e.b])) continue;
      changed_in[e.a] = changed_in[e.b] = round + 1;
      any = true;
    }
    stop.charge(work_weights::graded_pair * static_cast<double>(pairs));
    if (!any) return round;
  }
  return limit.most_rounds + 1;
}

}  // namespace asterism::internal::adapting
