// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "asterism/mesh/surface_audit/knot_spans.hpp"

namespace asterism::internal {
namespace {

std::optional<std::string> fault_of_points(const trim_curve& c) {
  for (std::size_t k = 0; k < c.control.size(); ++k) {
    const trim_point& p = c.control[k];
    for (const double x : {p.u, p.v})
      if (!std::isfinite(x) || !is_in_range(x))
        return fmt::format("control point {}: {:g} is out of range", k + 1, x);
    if (!std::isfinite(p.weight) || !(p.weight > 0) || !is_in_range(p.weight))
      return fmt::format("control point {}: its weight is {:g}, and a positive one is wanted",
                         k + 1, p.weight);
  }
  const auto is_first = [&](const trim_point& p) {
    return p.u == c.control[0].u && p.v == c.control[0].v;
  };
  if (std::all_of(c.control.begin(), c.control.end(), is_first))
    return std::string("all its control points are one point of the plane");
  return {};
}

std::optional<std::string> fault_of_curve(const trim_curve& c, int greatest_degree) {
  if (c.degree < 1 || c.degree > greatest_degree)
    return fmt::format("degree {}: 1 to {} can be treated", c.degree, greatest_degree);
  if (c.control.size() < static_cast<std::size_t>(c.degree) + 1)
    return fmt::format("{} control points for degree {}", c.control.size(), c.degree);
  if (auto wrong = fault_of_points(c)) return wrong;
  return fault_of_knots(c.knots, c.degree, c.control.size(), 't');
}

using plain_point = std::array<double, 3>;  // w u, w v, w

// Returns the span of knots that contains t.
std::size_t span_at(const trim_curve& c, double t) {
  const auto p = static_cast<std::size_t>(c.degree);
  const auto after = std::upper_bound(c.knots.begin() + static_cast<std::ptrdiff_t>(p) + 1,
                                      c.knots.end() - static_cast<std::ptrdiff_t>(p) - 1, t);
  return static_cast<std::size_t>(after - c.knots.begin()) - 1;
}

}  // namespace

std::optional<std::string> fault_of_trims(const surface_patch& p, int greatest_degree) {
  for (std::size_t l = 0; l < p.loops.size(); ++l) {
    if (p.loops[l].empty()) return fmt::format("loop {}: there is no curve in it", l + 1);
    for (std::size_t k = 0; k < p.loops[l].size(); ++k)
      if (auto wrong = fault_of_curve(p.loops[l][k], greatest_degree))
        return fmt::format("loop {}: curve {}: {}", l + 1, k + 1, *wrong);
  }
  return {};
}

std::vector<trim_link> trims_of(const surface_patch& p) {
  std::vector<trim_link> all;
  for (const trim_loop& loop : p.loops) {
    const std::size_t first = all.size();
    for (const trim_curve& c : loop) all.push_back({&c, all.size() + 1});
    all.back().next = first;
  }
  return all;
}

std::array<double, 2> trim_at(const trim_curve& c, double place) {
  if (place <= 0) return {c.control.front().u, c.control.front().v};
  if (place >= 1) return {c.control.back().u, c.control.back().v};
  const auto p = static_cast<std::size_t>(c.degree);
  std::vector<double> knots = c.knots;
  if (knots.empty()) {
    knots.assign(2 * (p + 1), 0);
    std::fill(knots.begin() + static_cast<std::ptrdiff_t>(p) + 1, knots.end(), 1.0);
  }
  const double t = knots.front() + place * (knots.back() - knots.front());
  const std::size_t span = c.knots.empty() ? p : span_at(c, t);
  std::vector<plain_point> d(p + 1);
  for (std::size_t k = 0; k <= p; ++k) {
    const trim_point& q = c.control[span - p + k];
    d[k] = {q.weight * q.u, q.weight * q.v, q.weight};
  }
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t k = p; k >= r; --k) {
      const double low = knots[span - p + k], high = knots[span + 1 + k - r];
      const double share = (t - low) / (high - low);
      for (std::size_t x = 0; x < 3; ++x) d[k][x] = d[k - 1][x] + share * (d[k][x] - d[k - 1][x]);
    }
  return {d[p][0] / d[p][2], d[p][1] / d[p][2]};
}

std::vector<double> knot_places(const trim_curve& c) {
  std::vector<double> places;
  for (const double k : c.knots) {
    const double place = (k - c.knots.front()) / (c.knots.back() - c.knots.front());
    if (place > 0 && place < 1 && (places.empty() || place > places.back()))
      places.push_back(place);
  }
  return places;
}

std::vector<trim_piece> trim_pieces(const trim_curve& c) {
  std::vector<weighted_point> control;
  for (const trim_point& p : c.control) {
    const rounded_interval w = p.weight;
    control.push_back({{w * rounded_interval(p.u), w * rounded_interval(p.v), 0}, w});
  }
  const std::vector<span_of_knots> spans = spans_of_knots(c.knots, c.degree);
  const rounded_interval first = spans.front().low,
                         all = rounded_interval(spans.back().high) - first;
  std::vector<trim_piece> pieces;
  for (const span_of_knots& s : spans) {
    const auto from = control.begin() + static_cast<std::ptrdiff_t>(s.first);
    const std::vector<weighted_point> own(from, from + c.degree + 1);
    trim_piece piece;
    piece.low = pieces.empty() ? rounded_interval(0) : pieces.back().high;
    piece.high =
        &s == &spans.back() ? rounded_interval(1) : quotient(rounded_interval(s.high) - first, all);
    piece.points = bezier_points(own, s, c.degree);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace asterism::internal
