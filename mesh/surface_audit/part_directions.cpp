// SPDX-License-Identifier: MIT
//
// Computes products in doubles rounded to nearest, with one bound of their errors for all points of
// a net: in intervals they were a quarter of the time of a proof.
//
// Let a vector d be known up to D in each component, its components at most Y, and g up to G,
// components at most M. Then d.g, of three products and two sums, is off by at most
//   3 (M D + G (Y + D)) + 3 * 4 * 2^-53 M Y,
// and the ends of a range, moved outward by that error and rounded once more, by a further 3 *
// 2^-53 M Y. A difference of two vectors off by D, of components at most Y, is off by 2 D + 2 *
// 2^-53 Y.
#include "asterism/mesh/surface_audit/part_directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/rough_bounds.hpp"

namespace asterism::internal {
namespace {

constexpr double unit = 0x1p-53;
// Bounds the underflow of three products, 2^-1074 each, in a sum and times `slack`.
constexpr double underflow = 0x1p-1060;
constexpr double infinity = std::numeric_limits<double>::infinity();

// A vector in doubles with an error of at most `off` in each component.
struct rough_vector {
  std::array<double, 3> at{};
  double off = 0;

  double greatest() const { return std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])}); }
};

rough_vector rough(const interval_vector& v) {
  const auto x = parted(v.x), y = parted(v.y), z = parted(v.z);
  return {{x.middle, y.middle, z.middle}, std::max({x.half, y.half, z.half})};
}

struct rough_frame {
  std::array<rough_vector, 3> axes;  // edge, across, normal
};

// Bounds the errors and the components of all vectors of a field.
struct rough_field {
  double off = 0, greatest = 0;
};

double error_of_products(const rough_vector& axis, const rough_field& field) {
  const double m = axis.greatest(), y = field.greatest;
  return (3 * (m * field.off + axis.off * (y + field.off)) + 3 * (m * y) * (5 * unit)) * slack +
         underflow;
}

// Ranges along the three axes, extended by each vector.
class axis_ranges {
 public:
  void include(const rough_frame& f, const std::array<double, 3>& d) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3>& g = f.axes[k].at;
      const double x = g[0] * d[0] + g[1] * d[1] + g[2] * d[2];
      low_[k] = std::min(low_[k], x), high_[k] = std::max(high_[k], x);
    }
  }
  std::optional<direction_range> taken(const rough_frame& f, const rough_field& field) const {
    std::array<rounded_interval, 3> ranges;
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = error_of_products(f.axes[k], field);
      if (!std::isfinite(error)) return std::nullopt;
      ranges[k] = rounded_interval(low_[k] - error, high_[k] + error);
    }
    return direction_range{ranges[0], ranges[1], ranges[2]};
  }

 private:
  std::array<double, 3> low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

// A net with its points relative to the frame's corner, times the weight.
struct moved_net {
  std::vector<std::array<double, 3>> at;
  std::vector<double> weight;
  rough_field field;      // of all of `at`
  double weight_off = 0;  // of all weights
};

moved_net moved(const triangle_net& net, const interval_vector& corner, bool is_rational) {
  const rough_vector origin = rough(corner);
  moved_net m;
  m.at.reserve(net.points.size());
  for (const weighted_point& c : net.points) {
    const rough_vector p = rough(c.at);
    const auto w = is_rational ? parted(c.weight) : middle_and_half{1, 0};
    std::array<double, 3>& q = m.at.emplace_back();
    for (std::size_t n = 0; n < 3; ++n) {
      const double from = w.middle * origin.at[n];
      q[n] = p.at[n] - from;
      m.field.greatest = std::max(m.field.greatest, std::abs(q[n]));
      m.field.off = std::max(m.field.off, p.off + w.half * std::abs(origin.at[n]) +
                                              unit * (std::abs(from) + std::abs(q[n])));
    }
    m.weight.push_back(w.middle);
    m.weight_off = std::max(m.weight_off, w.half);
  }
  m.field.off = m.field.off * slack + underflow;
  return m;
}

// Returns the range of the surface's points R / w (w the weight), relative to the frame's corner.
// Returns none if a weight is not certainly positive.
std::optional<direction_range> places(const rough_frame& f, const moved_net& net) {
  axis_ranges ranges;
  rough_field field;
  for (std::size_t k = 0; k < net.at.size(); ++k) {
    const double w = net.weight[k], least = w - net.weight_off;
    if (!(least > 0)) return std::nullopt;
    std::array<double, 3> q = net.at[k];
    for (double& x : q) {
      x /= w;
      field.greatest = std::max(field.greatest, std::abs(x));
      field.off = std::max(
          field.off, (net.field.off + std::abs(x) * net.weight_off) / least + unit * std::abs(x));
    }
    ranges.include(f, q);
  }
  field.off = field.off * slack + underflow;
  return ranges.taken(f, field);
}

struct field_and_weights {
  axis_ranges ranges;
  double low = infinity, high = -infinity;  // of the weights' differences
};

rounded_interval widened(double low, double high, double off) {
  const double error = (2 * off + 2 * unit * std::max(std::abs(low), std::abs(high))) * slack;
  return {low - error, high + error};
}

// Ranges of the differences of control points along two sides; for a quotient, also of the
// differences of weights and of the control points themselves.
struct side_ranges {
  direction_range first, second, place;
  std::array<rounded_interval, 2> weight;
};

[[gnu::noinline]] std::optional<side_ranges> to_nearest(const triangle_frame& frame,
                                                        const triangle_net& net, bool is_rational) {
  const rough_frame f{{rough(frame.edge), rough(frame.across), rough(frame.normal)}};
  const moved_net m = moved(net, frame.corner, is_rational);
  std::array<field_and_weights, 2> along;
  const int n = net.degree;
  for (int i = n - 1; i >= 0; --i)
    for (int j = n - 1 - i; j >= 0; --j) {
      const std::size_t from = net_index(n, i + 1, j);
      const std::array<std::size_t, 2> to = {net_index(n, i, j + 1), net_index(n, i, j)};
      for (std::size_t k = 0; k < 2; ++k) {
        const auto &a = m.at[from], &b = m.at[to[k]];
        along[k].ranges.include(f, {b[0] - a[0], b[1] - a[1], b[2] - a[2]});
        const double change = m.weight[to[k]] - m.weight[from];
        along[k].low = std::min(along[k].low, change);
        along[k].high = std::max(along[k].high, change);
      }
    }
  const rough_field differences{(2 * m.field.off + 2 * unit * m.field.greatest) * slack,
                                2 * m.field.greatest};
  const auto first = along[0].ranges.taken(f, differences),
             second = along[1].ranges.taken(f, differences);
  if (!first || !second) return std::nullopt;
  side_ranges ranges{*first, *second, {}, {}};
  if (!is_rational) return ranges;
  const auto place = places(f, m);
  if (!place) return std::nullopt;
  ranges.place = *place;
  for (std::size_t k = 0; k < 2; ++k)
    ranges.weight[k] = widened(along[k].low, along[k].high, m.weight_off);
  return ranges;
}

std::optional<side_ranges> ranges_along_sides(const triangle_frame& frame, const triangle_net& net,
                                              bool is_rational) {
  const floating_point_scope scope(rounding::nearest);
  return to_nearest(frame, net, is_rational);
}

}  // namespace

std::optional<two_directions> along_sides(const triangle_frame& frame, const triangle_net& net,
                                          bool is_rational) {
  const auto ranges = ranges_along_sides(frame, net, is_rational);
  if (!ranges) return std::nullopt;
  if (!is_rational) return two_directions{ranges->first, ranges->second, false};
  return two_directions{ranges->first - ranges->weight[0] * ranges->place,
                        ranges->second - ranges->weight[1] * ranges->place, false};
}

}  // namespace asterism::internal
