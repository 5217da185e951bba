// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/segment_division.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/numerics/arc_length.hpp"
#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {
namespace {

point at_fraction(const point& a, const point& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// Measures the length along the segment from a to b.
result<arc_length> length_along(const metric_field& field, const point& a, const point& b,
                                double fine) {
  const point d{b.x - a.x, b.y - a.y};
  return arc_length::measure(
      [&](double t) -> result<double> {
        const auto metric = field.at(at_fraction(a, b, t));
        if (!metric) return metric.failure();
        return std::sqrt(squared_length(metric.value(), d));
      },
      fine);
}

// Returns, for each vertex, the metric length that the first subsegments at it should have, on all
// its segments alike.
std::vector<double> first_subsegments(const domain& d, const std::vector<arc_length>& measured,
                                      double longest) {
  // Factor by which the first subsegments are shorter than the others, whose length is rounded down
  // to divide the segment evenly (docs/results/constants.md).
  constexpr double part_of_longest = 0.92;
  std::vector<double> wanted(d.vertices.size(), part_of_longest * longest);
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    for (const vertex_index v : {d.segments[s].a, d.segments[s].b})
      if (measured[s].total() > longest) wanted[v] = std::min(wanted[v], measured[s].total() / 2);
  return wanted;
}

// Returns the shift of points that divide a segment in this direction, as a part of a subsegment's
// length. All points of the boundary are shifted by about one common vector, which breaks the
// likely symmetries of a domain.
double shift_along(const point& direction) {
  constexpr double most = 1.0 / 64, aside = 0.375;
  return most * (direction.x + aside * direction.y) /
         (std::abs(direction.x) + std::abs(direction.y));
}

// Returns the points at these distances along the segment, the last of which is its length.
division at_lengths(const point& a, const point& b, const arc_length& measured,
                    const std::vector<double>& lengths) {
  division made;
  for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
    const point q = at_fraction(a, b, measured.parameter_at(lengths[i]));
    if (q == b || (!made.points.empty() && q == made.points.back())) continue;
    made.points.push_back(q);
    made.lengths.push_back(lengths[i]);
  }
  // Appends the end itself: the interpolated point can miss it by a rounding, which would leave a
  // subsegment of that length.
  made.points.push_back(b);
  made.lengths.push_back(lengths.back());
  return made;
}

// Divides a segment of which the first and the last subsegment are to be from_a and from_b long.
// Keeps to both if at least half a subsegment is left between them, so that none comes out shorter
// than that. Otherwise makes two or three subsegments: of about equal length if the lengths wanted
// at both ends differ by at most a quarter; else one end keeps its length, and the other gets the
// rest.
//
// Points between subsegments of equal length are shifted a little along the segment. At a corner
// where the metric is symmetric, like all corners of a square in many fields, both sides would
// otherwise be divided alike: four of their sites then are on one circle, up to rounding, and only
// exact numbers tell which diagonal is an edge. Parallel sides are shifted alike: those of a narrow
// strip stay divided alike.
division divide(const point& a, const point& b, const arc_length& measured, double from_a,
                double from_b, double longest) {
  const double shift = shift_along({b.x - a.x, b.y - a.y});
  const double total = measured.total();
  std::vector<double> lengths{0};
  const auto divide_evenly = [&](double until) {
    const double start = lengths.back();
    const auto subsegments =
        static_cast<std::size_t>(std::max(1.0, std::ceil((until - start) / longest)));
    const double step = (until - start) / static_cast<double>(subsegments);
    for (std::size_t i = 1; i < subsegments; ++i)
      lengths.push_back(start + (static_cast<double>(i) + shift) * step);
    lengths.push_back(until);
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
  return at_lengths(a, b, measured, lengths);
}

// Returns the number n of equal parts whose length has the ratio nearest to 1 to `wanted`: n rather
// than n + 1 where the geometric mean of both lengths is below `wanted`.
std::size_t parts_nearest_to(double total, double wanted) {
  const double fewer = std::max(1.0, std::floor(total / wanted));
  const bool one_more = total * total > fewer * (fewer + 1) * wanted * wanted;
  return static_cast<std::size_t>(fewer) + (one_more ? 1 : 0);
}

division divide_evenly(const point& a, const point& b, const arc_length& measured, double wanted) {
  const double total = measured.total(), shift = shift_along({b.x - a.x, b.y - a.y});
  const std::size_t parts = parts_nearest_to(total, wanted);
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < parts; ++i)
    lengths.push_back((static_cast<double>(i) + shift) * (total / static_cast<double>(parts)));
  lengths.push_back(total);
  return at_lengths(a, b, measured, lengths);
}

// Lengths along the segments of a domain, and the number of subsegments that all of them take.
struct measured_segments {
  std::vector<arc_length> of_each;
  double subsegments = 0;
};

result<measured_segments> measure_segments(const domain& d, const metric_field& field,
                                           double longest) {
  // Step, as a part of a subsegment's length, below which lengths along a segment are not sampled
  // further.
  constexpr double finest_part = 1.0 / 16;
  measured_segments measured;
  for (const segment& s : d.segments) {
    auto one = length_along(field, d.vertices[s.a], d.vertices[s.b], finest_part * longest);
    if (!one) return one.failure();
    measured.subsegments += one.value().total() / longest;
    measured.of_each.push_back(std::move(one).value());
  }
  if (std::isfinite(measured.subsegments)) return measured;
  return error{"the lengths of the domain's segments in this metric leave the range of doubles",
               error_code::invalid_metric};
}

}  // namespace

result<segment_divisions> divide_segments(const domain& d, const metric_field& field,
                                          double longest, std::size_t most_points) {
  const auto measured = measure_segments(d, field, longest);
  if (!measured) return measured.failure();
  segment_divisions made;
  made.subsegments = measured.value().subsegments;
  if (made.subsegments > static_cast<double>(most_points)) return made;
  const std::vector<arc_length>& of_each = measured.value().of_each;
  const std::vector<double> wanted = first_subsegments(d, of_each, longest);
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    made.of_each.push_back(divide(d.vertices[one.a], d.vertices[one.b], of_each[s], wanted[one.a],
                                  wanted[one.b], longest));
  }
  return made;
}

result<segment_divisions> divide_segments_evenly(const domain& d, const metric_field& field,
                                                 double shortest, double longest,
                                                 std::size_t most_points) {
  const auto measured = measure_segments(d, field, longest);
  if (!measured) return measured.failure();
  segment_divisions made;
  made.subsegments = measured.value().subsegments;
  if (made.subsegments > static_cast<double>(most_points)) return made;
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const segment& one = d.segments[s];
    made.of_each.push_back(divide_evenly(d.vertices[one.a], d.vertices[one.b],
                                         measured.value().of_each[s],
                                         std::sqrt(shortest * longest)));
  }
  return made;
}

}  // namespace asterism::internal
