// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/curve_composition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/mesh/surface_audit/ways_to_choose.hpp"

namespace asterism::internal {
namespace {

using polynomial = std::vector<rounded_interval>;  // times binomials

space_curve product(const polynomial& f, const space_curve& g) {
  space_curve h(f.size() + g.size() - 1, weighted_point{{0, 0, 0}, 0});
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j)
      h[i + j] = h[i + j] + weighted_point{f[i] * g[j].at, f[i] * g[j].weight};
  return h;
}

space_curve sum(space_curve a, const space_curve& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] + b[k];
  return a;
}

// Returns sum C(n, i) rest^(n - i) share^i c_i: de Casteljau with polynomials for shares.
space_curve blended(std::vector<space_curve> c, const polynomial& share, const polynomial& rest) {
  for (std::size_t left = c.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k)
      c[k] = sum(product(rest, c[k]), product(share, c[k + 1]));
  return c[0];
}

// The two shares t and 1 - t of a parameter between two knots as polynomials, times the weight and
// binomials.
struct two_shares {
  polynomial share, rest;
};

two_shares shares_of(const plane_curve& c, bool by_v, double low, double high) {
  const rounded_interval from = low, to = high, width = to - from;
  const int n = static_cast<int>(c.size()) - 1;
  two_shares shares;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const rounded_interval ways = ways_to_choose(n, static_cast<int>(k));
    const rounded_interval x = by_v ? c[k].at.y : c[k].at.x;
    shares.share.push_back(ways * quotient(x - from * c[k].weight, width));
    shares.rest.push_back(ways * quotient(to * c[k].weight - x, width));
  }
  return shares;
}

rounded_interval range_of(const plane_curve& c, bool by_v) {
  const auto of = [&](const weighted_point& p) {
    return quotient(by_v ? p.at.y : p.at.x, p.weight);
  };
  rounded_interval range = of(c[0]);
  for (const weighted_point& p : c) range = hull(range, of(p));
  return range;
}

// Returns the first and the last of the spans that a range reaches into.
std::pair<std::size_t, std::size_t> spans_in(const std::vector<double>& ends,
                                             const rounded_interval& range) {
  std::size_t first = 0, last = 0;
  for (std::size_t k = 1; k + 1 < ends.size(); ++k) {
    if (ends[k] <= range.inf()) first = k;
    if (ends[k] <= range.sup()) last = k;
  }
  return {first, last};
}

}  // namespace

plane_curve part_of_trim(const trim_piece& piece, const rounded_interval& from,
                         const rounded_interval& to) {
  const rounded_interval width = piece.high - piece.low;
  if (!(width.inf() > 0)) return {};
  const auto is_exactly = [](const rounded_interval& end, const rounded_interval& place) {
    return end.inf() == end.sup() && place.inf() == end.inf() && place.sup() == end.inf();
  };
  const auto local = [&](const rounded_interval& place) {
    if (is_exactly(piece.low, place)) return rounded_interval(0);
    if (is_exactly(piece.high, place)) return rounded_interval(1);
    return quotient(place - piece.low, width);
  };
  const rounded_interval a = local(from), b = local(to);
  plane_curve part;
  const std::size_t n = piece.points.size() - 1;
  for (std::size_t k = 0; k <= n; ++k) {
    std::vector<weighted_point> c = piece.points;
    for (std::size_t r = 1; r <= n; ++r) {
      const rounded_interval at = r <= k ? b : a;
      for (std::size_t i = 0; i + r <= n; ++i) c[i] = mixed(c[i], c[i + 1], at);
    }
    part.push_back(c[0]);
  }
  return part;
}

space_curve composed(const bezier_piece& piece, const plane_curve& curve,
                     const interval_vector& origin) {
  const two_shares s = shares_of(curve, false, piece.u_low, piece.u_high),
                   t = shares_of(curve, true, piece.v_low, piece.v_high);
  std::vector<space_curve> rows;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(piece.degree_u); ++i) {
    std::vector<space_curve> row;
    for (std::size_t j = 0; j < piece.row(); ++j) {
      const weighted_point& c = piece.net[i * piece.row() + j];
      row.push_back({{c.at - c.weight * origin, c.weight}});
    }
    rows.push_back(blended(std::move(row), t.share, t.rest));
  }
  return blended(std::move(rows), s.share, s.rest);
}

std::vector<std::uint32_t> pieces_along(const patch_spans& spans, const plane_curve& curve) {
  constexpr std::size_t most_pieces = 4;
  if (curve.empty()) return {};
  for (const weighted_point& p : curve)
    if (!(p.weight.inf() > 0)) return {};
  const auto u = spans_in(spans.u, range_of(curve, false)),
             v = spans_in(spans.v, range_of(curve, true));
  std::vector<std::uint32_t> all;
  if ((u.second - u.first + 1) * (v.second - v.first + 1) > most_pieces) return {};
  for (std::size_t i = u.first; i <= u.second; ++i)
    for (std::size_t j = v.first; j <= v.second; ++j)
      all.push_back(static_cast<std::uint32_t>(spans.first + i * (spans.v.size() - 1) + j));
  return all;
}

double squared_difference_above(const space_curve& a, const space_curve& b) {
  const std::size_t size = a.size() + b.size() - 1;
  std::vector<interval_vector> difference(size, interval_vector{0, 0, 0});
  std::vector<rounded_interval> weight(size, rounded_interval(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      difference[i + j] = difference[i + j] + (b[j].weight * a[i].at - a[i].weight * b[j].at);
      weight[i + j] = weight[i + j] + a[i].weight * b[j].weight;
    }
  double most = 0;
  for (std::size_t k = 0; k < size; ++k) {
    if (!(weight[k].inf() > 0)) return std::numeric_limits<double>::infinity();
    const double far = quotient(squared_length(difference[k]), squared(weight[k])).sup();
    // Refuses NaN and infinity, which products beyond the range of doubles leave.
    if (!(far <= std::numeric_limits<double>::max()))
      return std::numeric_limits<double>::infinity();
    most = std::max(most, far);
  }
  return most;
}

}  // namespace asterism::internal
