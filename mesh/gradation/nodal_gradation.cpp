// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/nodal_gradation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

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

// Returns a factor that is less than e^(2 most), the ratio of squared lengths at the limit: by a
// part of 7e-8 where `most` is 0.05, more than quick_log and roundings err.
double factor_below(double most) {
  // Sums the first five terms of the exponential series: all terms are positive, so less than the
  // whole.
  const double x = 2 * most;
  return 1 + x * (1 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24))));
}

// True only if no squared length in either tensor exceeds the other's by more than this factor:
// these multiples of each tensor, less the other, are positive definite. Needs no eigenvalue, and
// decides nearly all pairs that are within the limit.
bool are_plainly_alike(const metric_tensor& a, const metric_tensor& b, double factor) {
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

// A set of numbered edges, in words that several threads may fill.
class edge_set {
 public:
  static constexpr std::size_t word_bits = 64;

  explicit edge_set(std::size_t edges) : words_(chunk_count(edges, word_bits), 0) {}

  void add(std::size_t i) { words_[i / word_bits] |= std::uint64_t{1} << i % word_bits; }
  void remove(std::size_t i) { words_[i / word_bits] &= ~(std::uint64_t{1} << i % word_bits); }
  bool has(std::size_t i) const { return (words_[i / word_bits] >> i % word_bits & 1U) != 0; }
  void clear() { std::fill(words_.begin(), words_.end(), 0); }
  // Adds the edges of which the number is below `edges`.
  void fill(std::size_t edges) {
    const std::size_t whole = edges / word_bits;
    std::fill_n(words_.begin(), whole, ~std::uint64_t{0});
    for (std::size_t i = whole * word_bits; i < edges; ++i) add(i);
  }
  std::size_t count() const {
    std::size_t sum = 0;
    for (const std::uint64_t w : words_) sum += static_cast<std::size_t>(std::popcount(w));
    return sum;
  }
  // Returns the least number in the set that is at least `from`, or `none` if there is none.
  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t first_from(std::size_t from) const {
    std::size_t w = from / word_bits;
    if (w >= words_.size()) return none;
    std::uint64_t bits = words_[w] & ~std::uint64_t{0} << from % word_bits;
    while (bits == 0)
      if (++w == words_.size())
        return none;
      else
        bits = words_[w];
    return w * word_bits + static_cast<std::size_t>(std::countr_zero(bits));
  }

 private:
  std::vector<std::uint64_t> words_;
};

// Lists the edges at each node of a graph, ascending.
class edges_of_nodes {
 public:
  edges_of_nodes(std::size_t nodes, const std::vector<graph_edge>& edges) : first_(nodes + 1, 0) {
    resize_in_threads(all_, 2 * edges.size());
    for (const graph_edge& e : edges) {
      ++first_[e.a];
      ++first_[e.b];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& f : first_) f = end += f;
    for (std::size_t i = edges.size(); i-- > 0;) {
      all_[--first_[edges[i].a]] = static_cast<std::uint32_t>(i);
      all_[--first_[edges[i].b]] = static_cast<std::uint32_t>(i);
    }
  }

  std::span<const std::uint32_t> at(vertex_index v) const {
    return {all_.data() + first_[v], all_.data() + first_[v + 1]};
  }

 private:
  std::vector<std::uint32_t> first_, all_;
};

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
        least_factor_(factor_below(most_at(0))),
        tensors_(tensors),
        due_(edges.size()),
        unlike_(edges.size()),
        open_(edges.size()) {
    due_.fill(edges.size());
  }

  // Clips the tensors of each due edge that exceeds its limit; returns true if any were changed.
  // All edges are due in the first round, and edges at a changed node from then on to the end of
  // the next round. Adds the number of tests of edges to `pairs`.
  bool round(std::size_t number, std::size_t& pairs) {
    const double coarser_part = number <= limit_.uneven_rounds ? limit_.coarser_part : 0.5;
    pairs += due_.count();
    find_open();
    due_.clear();
    bool any = false;
    for (std::size_t i = open_.first_from(0); i != edge_set::none; i = open_.first_from(i + 1)) {
      ++pairs;
      const graph_edge& e = edges_[i];
      if ((!unlike_.has(i) && is_surely_alike(e)) || !make_ends_alike(e, coarser_part)) {
        due_.remove(i);
        continue;
      }
      note_change(e.a, i);
      note_change(e.b, i);
      any = true;
    }
    return any;
  }

 private:
  double most_at(double mean) const {
    return at_unit_ * std::clamp(mean / limit_.unit, limit_.shortest, limit_.longest);
  }

  // Finds the due edges that are not certainly within the limit. Nearly all are, and this is most
  // of a round's work.
  void find_open() {
    constexpr std::size_t chunk = 64 * edge_set::word_bits;  // threads fill words of their own
    open_.clear();
    parallel_chunks(edges_.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = due_.first_from(begin); i < end; i = due_.first_from(i + 1))
        if (!is_surely_alike(edges_[i])) open_.add(i);
    });
    unlike_ = open_;
  }

  // Notes that the tensor of v was changed for edge i: all edges there are due in the next round,
  // and those after i in this one, too.
  void note_change(vertex_index v, std::size_t i) {
    if (!edges_at_) edges_at_.emplace(places_.size(), edges_);
    for (const std::uint32_t k : edges_at_->at(v)) {
      due_.add(k);
      unlike_.remove(k);
      if (k > i) open_.add(k);
    }
  }

  // Tries the least limit of any edge first, which does not depend on its length.
  bool is_surely_alike(const graph_edge& e) const {
    const metric_tensor &a = tensors_[e.a], &b = tensors_[e.b];
    if (are_plainly_alike(a, b, least_factor_)) return true;
    const point d{places_[e.b].x - places_[e.a].x, places_[e.b].y - places_[e.a].y};
    // Uses the geometric mean of both lengths, which is less than the logarithmic one.
    const double mean = std::sqrt(std::sqrt(plain_square(a, d) * plain_square(b, d)));
    return are_plainly_alike(a, b, factor_below(most_at(mean)));
  }

  bool make_ends_alike(const graph_edge& e, double coarser_part) {
    const point d{places_[e.b].x - places_[e.a].x, places_[e.b].y - places_[e.a].y};
    const double at_a = plain_length(tensors_[e.a], d), at_b = plain_length(tensors_[e.b], d);
    const simultaneous_reduction r = reduce(tensors_[e.a], tensors_[e.b]);
    const double most = most_at(logarithmic_mean(at_a, at_b, quick_log));
    return clip_distortion_by(r, most, coarser_part, tensors_[e.a], tensors_[e.b]);
  }

  const std::vector<point>& places_;
  const std::vector<graph_edge>& edges_;
  const gradation_limit& limit_;
  double at_unit_;
  double least_factor_;  // that the ends of an edge may differ by, whatever its length
  std::vector<metric_tensor>& tensors_;
  std::optional<edges_of_nodes> edges_at_;  // made at the first change
  edge_set due_;                            // edges to test in the next round
  edge_set unlike_;                         // open edges that were tested, with the present tensors
  edge_set open_;                           // edges to test that are not known to be alike
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
