// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/segment_division.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {
namespace {

point at_fraction(const point& a, const point& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// The length from the start of a segment as a function of the fraction of the way, sampled where
// it bends: intervals are halved until the three measurements in each agree.
class arc_length {
 public:
  static result<arc_length> measure(const metric_field& field, const point& a, const point& b,
                                    double fine) {
    arc_length measured(field, a, b, fine);
    const auto first = measured.speed(0), last = measured.speed(1);
    measured.fractions_.push_back(0);
    measured.lengths_.push_back(0);
    measured.add(0, first, 1, last, 0);
    if (measured.failure_) return *measured.failure_;
    return measured;
  }

  double total() const { return lengths_.back(); }
  double length_at(double t) const { return interpolate(fractions_, lengths_, t); }
  double fraction_at(double length) const { return interpolate(lengths_, fractions_, length); }

 private:
  // Sixteen intervals at least, so that a segment cannot hide a bend from three samples; at most
  // 2^18, by which an interval of even the steepest metric that is meshed is far below `fine`.
  static constexpr int least_depth = 4, most_depth = 18;
  // Agreement of the speeds at the ends and in the middle: Simpson's rule is then off by less than
  // a thousandth (docs/results/constants.md has others).
  static constexpr double agreement = 0.05;

  arc_length(const metric_field& field, const point& a, const point& b, double fine)
      : field_(&field), a_(a), b_(b), fine_(fine) {}

  double speed(double t) {
    if (failure_) return 0;
    const auto metric = field_->at(at_fraction(a_, b_, t));
    if (!metric) {
      failure_ = metric.failure();
      return 0;
    }
    const point d{b_.x - a_.x, b_.y - a_.y};
    return std::sqrt(squared_length(metric.value(), d));
  }

  void add(double t0, double v0, double t1, double v1, int depth) {
    const double t = (t0 + t1) / 2, v = speed(t);
    if (failure_) return;
    const double length = (t1 - t0) * (v0 + 4 * v + v1) / 6;
    const bool even = std::max({v0, v, v1}) <= (1 + agreement) * std::min({v0, v, v1});
    if (depth < least_depth || (depth < most_depth && !even && length > fine_)) {
      add(t0, v0, t, v, depth + 1);
      add(t, v, t1, v1, depth + 1);
      return;
    }
    fractions_.push_back(t1);
    lengths_.push_back(lengths_.back() + length);
  }

  static double interpolate(const std::vector<double>& from, const std::vector<double>& to,
                            double x) {
    const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, x);
    const auto i = static_cast<std::size_t>(above - from.begin());
    const double part = (x - from[i - 1]) / (from[i] - from[i - 1]);
    return to[i - 1] + std::clamp(part, 0.0, 1.0) * (to[i] - to[i - 1]);
  }

  const metric_field* field_;
  point a_, b_;
  double fine_;
  std::vector<double> fractions_, lengths_;
  std::optional<error> failure_;
};

// Returns, for each vertex, the metric length wanted of the first subsegments at it, the same on
// all its segments.
std::vector<double> first_subsegments(const domain& d, const std::vector<arc_length>& measured,
                                      double longest) {
  // A little shorter than the others, whose length is rounded down to divide the segment evenly
  // (docs/results/constants.md).
  constexpr double part_of_longest = 0.92;
  std::vector<double> wanted(d.vertices.size(), part_of_longest * longest);
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    for (const vertex_index v : {d.segments[s].a, d.segments[s].b})
      if (measured[s].total() > longest) wanted[v] = std::min(wanted[v], measured[s].total() / 2);
  return wanted;
}

// Divides a segment of which the first and the last subsegment are to be from_a and from_b long.
// Keeps to both if at least half a subsegment is left between them, so that none comes out shorter
// than that. Otherwise there are two or three: of about equal length if the ends want about the
// same, within a quarter; else one end keeps its length, and the other gets the rest.
division divide(const point& a, const point& b, const arc_length& measured, double from_a,
                double from_b, double longest) {
  const double total = measured.total();
  std::vector<double> lengths{0};
  const auto divide_evenly = [&](double until) {
    const double start = lengths.back();
    const auto subsegments =
        static_cast<std::size_t>(std::max(1.0, std::ceil((until - start) / longest)));
    for (std::size_t i = 1; i <= subsegments; ++i)
      lengths.push_back(start + (until - start) * static_cast<double>(i) /
                                    static_cast<double>(subsegments));
  };
  if (total > longest && from_a + from_b < total - longest / 2) {
    lengths.push_back(from_a);
    divide_evenly(total - from_b);
    lengths.push_back(total);
  } else if (total > longest && std::abs(from_a - from_b) < longest / 4) {
    divide_evenly(total);
  } else if (total > longest) {
    lengths.push_back(std::min(std::max(from_a, total - longest), longest));
    lengths.push_back(total);
  } else {
    lengths.push_back(total);
  }
  division made;
  lengths.pop_back();
  for (const double length : lengths) {
    const point q = at_fraction(a, b, measured.fraction_at(length));
    if (q == b || (!made.points.empty() && q == made.points.back())) continue;
    made.points.push_back(q);
    made.lengths.push_back(length);
  }
  // Not interpolated: that can miss the end by rounding, which would leave a subsegment as short.
  made.points.push_back(b);
  made.lengths.push_back(total);
  return made;
}

}  // namespace

result<segment_divisions> divide_segments(const domain& d, const metric_field& field,
                                          double longest, std::size_t most_points) {
  // Part of a subsegment's length below which lengths are not sampled further.
  constexpr double finest_part = 1.0 / 16;
  std::vector<arc_length> measured;
  segment_divisions made;
  for (const segment& s : d.segments) {
    auto one = arc_length::measure(field, d.vertices[s.a], d.vertices[s.b], finest_part * longest);
    if (!one) return one.failure();
    made.subsegments += one.value().total() / longest;
    measured.push_back(std::move(one).value());
  }
  if (!std::isfinite(made.subsegments))
    return error{"the lengths of the domain's segments in this metric leave the range of doubles",
                 error_code::invalid_metric};
  if (made.subsegments > static_cast<double>(most_points)) return made;
  const std::vector<double> wanted = first_subsegments(d, measured, longest);
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    made.of_each.push_back(divide(d.vertices[one.a], d.vertices[one.b], measured[s], wanted[one.a],
                                  wanted[one.b], longest));
  }
  return made;
}

}  // namespace asterism::internal
