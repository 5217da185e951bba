// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/nodal_gradation.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/numerics/quick_logarithm.hpp"
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

bool is_metric(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m22) && m.m11 > 0 &&
         std::fma(m.m11, m.m22, -m.m12 * m.m12) > 0;
}

// True only if the log distortion of the reduced pair is at most `most` as clip_distortion_by()
// computes it. Needs no logarithm for most pairs, since |ln x| <= |x - 1| / root x.
bool are_surely_alike(const simultaneous_reduction& r, double most) {
  // Factor that reduces the limit of |ln ratio|, 2 * most. The margin, 2e-9 * most, exceeds the
  // error of quick_log, 1e-13, and roundings of some 1e-16 for limits of 1e-4 and more; limits of
  // meshes are above 0.05. With a smaller limit, a pair that exceeds it by 1e-13 may be accepted.
  constexpr double roundings = 1 - 1e-9;
  const auto is_within = [most](double ratio) {
    const double s = std::sqrt(ratio);
    return std::abs(s - 1) <= most * roundings * std::sqrt(s);
  };
  return is_within(r.high) && is_within(r.low);
}

// True only if no length in either tensor exceeds e^most times the other's: these multiples of each
// tensor, less the other, are positive definite. Needs no eigenvalue, and decides nearly all pairs
// that are within the limit.
bool are_plainly_alike(const metric_tensor& a, const metric_tensor& b, double most) {
  // Sums the beginning of the series of e^(2 most), which is less than it: by a part of 7e-8 where
  // `most` is 0.05, more than quick_log and roundings err.
  const double x = 2 * most;
  const double factor = 1 + x * (1 + x / 2 * (1 + x / 3 * (1 + x / 4)));
  const auto covers = [factor](const metric_tensor& p, const metric_tensor& q) {
    // Rounding errors of the determinant are below 10 * 2^-53 times this product.
    constexpr double roundings = 1e-14;
    const double m11 = factor * p.m11, m22 = factor * p.m22, m12 = factor * p.m12 - q.m12;
    return m11 > q.m11 &&
           (m11 - q.m11) * (m22 - q.m22) - m12 * m12 > roundings * ((m11 + q.m11) * (m22 + q.m22));
  };
  return covers(a, b) && covers(b, a);
}

bool clip_distortion_by(const simultaneous_reduction& r, double most, double coarser_part,
                        metric_tensor& a, metric_tensor& b) {
  const double high = quick_log(r.high), low = quick_log(r.low);
  if (!(std::max(std::abs(high), std::abs(low)) > 2 * most)) return false;
  // Part of the limit that a clipped pair is brought to, so that later rounds do not approach the
  // limit in ever smaller steps. If each tensor takes half of the excess, the pair moves to the
  // nearest pair within that part of the limit.
  constexpr double aim = 0.98;
  // Returns the signed excess of a logarithm over the aim. `part` returns the share of it that
  // changes a: a is the coarser tensor in a direction in which b measures more.
  const auto excess = [&](double logarithm) {
    const double size = std::abs(logarithm);
    return size > aim * 2 * most ? (1 - aim * 2 * most / size) * logarithm : 0;
  };
  const auto part = [&](double whole) {
    return whole * (whole > 0 ? coarser_part : 1 - coarser_part);
  };
  // Multiplies by an exponential; returns a value unchanged where the excess is 0.
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

bool clip_distortion(metric_tensor& a, metric_tensor& b, double most, double coarser_part) {
  const simultaneous_reduction r = reduce(a, b);
  return !are_surely_alike(r, most) && clip_distortion_by(r, most, coarser_part, a, b);
}

namespace {

// Clips the tensors along the edges of a graph, in rounds, until the ends of each edge are within
// its limit.
class graph_grading {
 public:
  graph_grading(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                const gradation_limit& limit, std::vector<metric_tensor>& tensors)
      : places_(places),
        edges_(edges),
        limit_(limit),
        at_unit_(elementary::log(limit.distortion)),
        tensors_(tensors),
        changed_in_(places.size(), 1),
        is_alike_(edges.size(), 0) {}

  // Clips the tensors of each edge that exceeds its limit; returns true if any were changed. Adds
  // the number of edges visited to `pairs`.
  bool round(std::size_t number, std::size_t& pairs) {
    find_alike(number);
    const double coarser_part = number <= limit_.uneven_rounds ? limit_.coarser_part : 0.5;
    bool any = false;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const graph_edge& e = edges_[i];
      if (!is_due(e, number)) continue;
      ++pairs;
      // Skips an edge that was within its limit before the round, unless an end has changed since.
      if (is_alike_[i] != 0 && !is_due(e, number + 1)) continue;
      if (!make_ends_alike(e, coarser_part)) continue;
      changed_in_[e.a] = changed_in_[e.b] = number + 1;
      any = true;
    }
    return any;
  }

 private:
  bool is_due(const graph_edge& e, std::size_t number) const {
    return changed_in_[e.a] >= number || changed_in_[e.b] >= number;
  }

  double most_at(double mean) const {
    return at_unit_ * std::clamp(mean / limit_.unit, limit_.shortest, limit_.longest);
  }

  // Marks the edges that are due and certainly within the limit: nearly all of them, and most of a
  // round's work.
  void find_alike(std::size_t number) {
    constexpr std::size_t chunk = 4096;
    parallel_chunks(edges_.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        is_alike_[i] = is_due(edges_[i], number) && is_surely_alike(edges_[i]) ? 1 : 0;
    });
  }

  bool is_surely_alike(const graph_edge& e) const {
    const point d{places_[e.b].x - places_[e.a].x, places_[e.b].y - places_[e.a].y};
    // Uses the geometric mean of both lengths, which is less than the logarithmic one.
    const double mean = std::sqrt(plain_length(tensors_[e.a], d) * plain_length(tensors_[e.b], d));
    return are_plainly_alike(tensors_[e.a], tensors_[e.b], most_at(mean));
  }

  bool make_ends_alike(const graph_edge& e, double coarser_part) {
    const point d{places_[e.b].x - places_[e.a].x, places_[e.b].y - places_[e.a].y};
    const double at_a = plain_length(tensors_[e.a], d), at_b = plain_length(tensors_[e.b], d);
    const simultaneous_reduction r = reduce(tensors_[e.a], tensors_[e.b]);
    if (are_surely_alike(r, most_at(std::sqrt(at_a * at_b)))) return false;
    const double most = most_at(logarithmic_mean(at_a, at_b, quick_log));
    return clip_distortion_by(r, most, coarser_part, tensors_[e.a], tensors_[e.b]);
  }

  const std::vector<point>& places_;
  const std::vector<graph_edge>& edges_;
  const gradation_limit& limit_;
  double at_unit_;
  std::vector<metric_tensor>& tensors_;
  // Round, by node, from which edges with this end must be tested again.
  std::vector<std::size_t> changed_in_;
  std::vector<char> is_alike_;  // edges, at the beginning of the round
};

}  // namespace

std::size_t grade(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                  const gradation_limit& limit, std::vector<metric_tensor>& tensors,
                  const cancellation& stop) {
  graph_grading grading(places, edges, limit, tensors);
  for (std::size_t round = 1; round <= limit.most_rounds && !stop.is_requested(); ++round) {
    std::size_t pairs = 0;
    const bool any = grading.round(round, pairs);
    stop.charge(work_weights::graded_pair * static_cast<double>(pairs));
    if (!any) return round;
  }
  return limit.most_rounds + 1;
}

}  // namespace asterism::internal::adapting
