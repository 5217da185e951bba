// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/knot_spans.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "asterism/mesh/surface_audit/number_ranges.hpp"

namespace asterism::internal {

bool is_in_range(double x) {
  const double modulus = std::abs(x);
  return x == 0 || (modulus <= greatest_modulus && modulus >= least_modulus);
}

std::optional<std::string> fault_of_knots(const std::vector<double>& knots, int degree,
                                          std::size_t count, char direction) {
  const auto p = static_cast<std::size_t>(degree);
  if (knots.empty()) {
    if (count == p + 1) return {};
    return fmt::format("{} control points in {} without knots: degree {} takes {}", count,
                       direction, degree, p + 1);
  }
  if (knots.size() != count + p + 1)
    return fmt::format("{} knots in {}: {} control points of degree {} take {}", knots.size(),
                       direction, count, degree, count + p + 1);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]) || !is_in_range(knots[i]))
      return fmt::format("knot {} in {} is {:g}, out of range", i + 1, direction, knots[i]);
    if (i > 0 && knots[i] < knots[i - 1])
      return fmt::format("knot {} in {} is below the one before it", i + 1, direction);
  }
  for (std::size_t i = 1; i <= p; ++i)
    if (knots[i] != knots[0] || knots[knots.size() - 1 - i] != knots.back())
      return fmt::format("the first and the last knot in {} must stand {} times", direction, p + 1);
  if (!(knots.front() < knots.back())) return fmt::format("all knots in {} are equal", direction);
  for (std::size_t i = 1; i + p + 1 < knots.size(); ++i)
    if (knots[i] == knots[i + p] && i + p + 1 < knots.size() && knots[i] != knots.front() &&
        knots[i] != knots.back())
      return fmt::format("knot {} in {} stands more than {} times: the patch would be torn there",
                         i + 1, direction, degree);
  return {};
}

std::vector<span_of_knots> spans_of_knots(const std::vector<double>& knots, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  if (knots.empty()) return {span_of_knots{}};
  std::vector<span_of_knots> all;
  for (std::size_t i = p; i + p + 1 < knots.size(); ++i) {
    if (knots[i] == knots[i + 1]) continue;
    span_of_knots s{knots[i], knots[i + 1], i - p, {}};
    for (std::size_t k = i - p + 1; k <= i + p; ++k) s.knots.emplace_back(knots[k]);
    all.push_back(std::move(s));
  }
  return all;
}

namespace {

// Returns the polar form of the span's polynomial with `highs` arguments equal to `high`, the
// others to `low`: the Bezier point of that number. Source: Ramshaw, "Blossoming", 1987.
weighted_point polar_value(std::vector<weighted_point> c, const span_of_knots& s, int degree,
                           int highs) {
  for (int r = 1; r <= degree; ++r) {
    const rounded_interval at = r <= highs ? s.high : s.low;
    for (int i = 0; i + r <= degree; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const rounded_interval& from = s.knots[static_cast<std::size_t>(i + r - 1)];
      const rounded_interval& to = s.knots[k + static_cast<std::size_t>(degree)];
      const rounded_interval share = quotient(at - from, to - from);
      c[k] = mixed(c[k], c[k + 1], share);
    }
  }
  return c[0];
}

}  // namespace

std::vector<weighted_point> bezier_points(const std::vector<weighted_point>& c,
                                          const span_of_knots& s, int degree) {
  if (s.knots.empty()) return c;
  std::vector<weighted_point> out;
  for (int k = 0; k <= degree; ++k) out.push_back(polar_value(c, s, degree, k));
  return out;
}

}  // namespace asterism::internal
