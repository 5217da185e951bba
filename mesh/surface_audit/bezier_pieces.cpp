// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/knot_spans.hpp"
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

error refuse(const surface_patch& p, std::size_t number, const std::string& what) {
  const std::string name = p.name.empty() ? "" : " (" + p.name + ")";
  return {fmt::format("patch {}{}: {}", number, name, what), error_code::invalid_input};
}

failure fault_of_control(const surface_patch& p, std::size_t number) {
  if (p.control.size() != p.count_u * p.count_v)
    return refuse(p, number, "rows of control points of different lengths");
  bool one_point = true;
  for (std::size_t k = 0; k < p.control.size(); ++k) {
    const control_point& c = p.control[k];
    const std::string where =
        fmt::format("control point {}, {}", k / p.count_v + 1, k % p.count_v + 1);
    for (const double x : {c.at.x, c.at.y, c.at.z})
      if (!std::isfinite(x) || !is_in_range(x))
        return refuse(p, number, fmt::format("{}: coordinate {:g} is out of range", where, x));
    if (!std::isfinite(c.weight) || !(c.weight > 0))
      return refuse(p, number,
                    fmt::format("{}: its weight is {:g}, and only positive weights keep a patch in "
                                "the hull of its control points",
                                where, c.weight));
    if (!is_in_range(c.weight))
      return refuse(p, number, fmt::format("{}: weight {:g} is out of range", where, c.weight));
    one_point = one_point && c.at == p.control[0].at;
  }
  if (one_point) return refuse(p, number, "all control points are one point: it has no area");
  return {};
}

failure fault_of(const surface_patch& p, std::size_t number) {
  for (const auto& [degree, count, direction] :
       {std::tuple{p.degree_u, p.count_u, 'u'}, std::tuple{p.degree_v, p.count_v, 'v'}}) {
    if (degree < 1 || degree > most_degree)
      return refuse(
          p, number,
          fmt::format("degree {} in {}: 1 to {} can be treated", degree, direction, most_degree));
    if (count < static_cast<std::size_t>(degree) + 1)
      return refuse(p, number,
                    fmt::format("{} control points in {} for degree {}", count, direction, degree));
  }
  if (auto wrong = fault_of_control(p, number)) return wrong;
  if (auto wrong = fault_of_knots(p.knots_u, p.degree_u, p.count_u, 'u'))
    return refuse(p, number, *wrong);
  if (auto wrong = fault_of_knots(p.knots_v, p.degree_v, p.count_v, 'v'))
    return refuse(p, number, *wrong);
  if (auto wrong = fault_of_trims(p, most_degree)) return refuse(p, number, *wrong);
  return {};
}

weighted_point lift(const control_point& c) {
  const rounded_interval w = c.weight;
  return {w * vector_of<rounded_interval>(c.at), w};
}

// Marks the sides of the patch at this piece that are one point.
void mark_points(const surface_patch& p, const span_of_knots& u, const span_of_knots& v,
                 bezier_piece& piece) {
  const std::size_t last_u = p.count_u - 1, last_v = p.count_v - 1;
  const auto is_one = [](const control_point& a, const control_point& b) { return a.at == b.at; };
  const std::array<bool, 4> here = {
      u.first == 0, u.first + static_cast<std::size_t>(p.degree_u) == last_u, v.first == 0,
      v.first + static_cast<std::size_t>(p.degree_v) == last_v};
  for (std::size_t side = 0; side < 4; ++side) {
    if (!here[side]) continue;
    const bool along_v = side < 2, at_end = side % 2 == 1;
    const auto at = [&](std::size_t k) {
      return along_v ? p.at(at_end ? last_u : 0, k) : p.at(k, at_end ? last_v : 0);
    };
    piece.is_point[side] = true;
    piece.point[side] = at(0).at;
    for (std::size_t k = 1; k <= (along_v ? last_v : last_u); ++k)
      piece.is_point[side] = piece.is_point[side] && is_one(at(0), at(k));
  }
}

bezier_piece make_piece(const surface_patch& p, const span_of_knots& u, const span_of_knots& v) {
  bezier_piece piece;
  piece.degree_u = p.degree_u, piece.degree_v = p.degree_v;
  piece.u_low = u.low, piece.u_high = u.high, piece.v_low = v.low, piece.v_high = v.high;
  const std::size_t rows = static_cast<std::size_t>(p.degree_u) + 1, row = piece.row();
  std::vector<std::vector<weighted_point>> columns;  // of constant j, along u
  for (std::size_t j = 0; j < row; ++j) {
    std::vector<weighted_point> column;
    for (std::size_t i = 0; i < rows; ++i) column.push_back(lift(p.at(u.first + i, v.first + j)));
    columns.push_back(bezier_points(column, u, p.degree_u));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<weighted_point> across;
    for (std::size_t j = 0; j < row; ++j) across.push_back(columns[j][i]);
    for (const weighted_point& c : bezier_points(across, v, p.degree_v)) piece.net.push_back(c);
  }
  mark_points(p, u, v, piece);
  piece.is_rational = std::any_of(p.control.begin(), p.control.end(),
                                  [](const control_point& c) { return c.weight != 1; });
  // Sets the weights of a polynomial to 1: in exact arithmetic the computed weights are 1, but
  // their intervals are wider.
  if (!piece.is_rational)
    for (weighted_point& c : piece.net) c.weight = 1;
  for (const weighted_point& c : piece.net)
    piece.plain_net.push_back(
        {middle_of(c.at.x), middle_of(c.at.y), middle_of(c.at.z), middle_of(c.weight)});
  return piece;
}

[[gnu::noinline]] void add_pieces(const surface_patch& p, std::uint32_t number,
                                  std::vector<bezier_piece>& pieces) {
  for (const span_of_knots& u : spans_of_knots(p.knots_u, p.degree_u))
    for (const span_of_knots& v : spans_of_knots(p.knots_v, p.degree_v)) {
      pieces.push_back(make_piece(p, u, v));
      pieces.back().patch = number;
    }
}

}  // namespace

result<std::vector<bezier_piece>> bezier_pieces(const surface& s) {
  if (s.patches.empty()) return error{"the surface has no patch", error_code::invalid_input};
  for (std::size_t i = 0; i < s.patches.size(); ++i)
    if (auto wrong = fault_of(s.patches[i], i + 1)) return *wrong;
  std::vector<bezier_piece> pieces;
  const floating_point_scope scope(rounding::upward);
  for (std::size_t i = 0; i < s.patches.size(); ++i)
    add_pieces(s.patches[i], static_cast<std::uint32_t>(i), pieces);
  return pieces;
}

namespace {

using plain_control = std::array<double, 4>;

plain_control mixed(const plain_control& a, const plain_control& b, double share) {
  plain_control c;
  for (std::size_t k = 0; k < 4; ++k) c[k] = a[k] + share * (b[k] - a[k]);
  return c;
}

using plain_row = std::array<plain_control, most_degree + 1>;

// The value, first and second derivative of a Bezier curve in four coordinates.
struct curve_jet {
  plain_control value, first, second;
};

// Evaluates a Bezier curve, and overwrites its control points. Computes the second derivative only
// on request: most evaluations are for a step of a projection, which does not use it.
template <bool twice>
curve_jet along(plain_row& c, int degree, double share) {
  curve_jet jet;
  jet.first.fill(0);
  if constexpr (twice) jet.second.fill(0);
  const double p = degree;
  for (int left = degree; left > 0; --left) {
    if constexpr (twice)
      if (left == 2)
        for (std::size_t k = 0; k < 4; ++k)
          jet.second[k] = p * (p - 1) * (c[2][k] - 2 * c[1][k] + c[0][k]);
    if (left == 1)
      for (std::size_t k = 0; k < 4; ++k) jet.first[k] = p * (c[1][k] - c[0][k]);
    for (int i = 0; i < left; ++i) {
      const auto at = static_cast<std::size_t>(i);
      c[at] = mixed(c[at], c[at + 1], share);
    }
  }
  jet.value = c[0];
  return jet;
}

// Value and derivatives of the projective point, in four coordinates.
struct projective_jet {
  plain_control value, s, t, ss, st, tt;
};

template <bool twice>
projective_jet projective(const bezier_piece& piece, double s, double t) {
  plain_row values, firsts, seconds, row;  // as far as the degrees go
  for (std::size_t i = 0; i <= static_cast<std::size_t>(piece.degree_u); ++i) {
    for (std::size_t j = 0; j < piece.row(); ++j) row[j] = piece.plain_net[i * piece.row() + j];
    const curve_jet jet = along<twice>(row, piece.degree_v, t);
    values[i] = jet.value, firsts[i] = jet.first;
    if constexpr (twice) seconds[i] = jet.second;
  }
  const curve_jet value = along<twice>(values, piece.degree_u, s),
                  by_t = along<twice>(firsts, piece.degree_u, s);
  projective_jet jet;
  jet.value = value.value, jet.s = value.first, jet.t = by_t.value;
  if constexpr (twice) {
    jet.ss = value.second, jet.st = by_t.first;
    jet.tt = along<twice>(seconds, piece.degree_u, s).value;
  }
  return jet;
}

plain_vector first_three(const plain_control& c) { return {c[0], c[1], c[2]}; }

// Returns the derivative of a quotient: (c - at * weight) / w.
plain_vector quotient_slope(const plain_control& c, const plain_vector& at, double w) {
  return (1 / w) * (first_three(c) - c[3] * at);
}

plain_jet first_of(const projective_jet& j) {
  const double w = j.value[3];
  const plain_vector at = (1 / w) * first_three(j.value);
  return {at, quotient_slope(j.s, at, w), quotient_slope(j.t, at, w)};
}

}  // namespace

plain_jet evaluate(const bezier_piece& piece, double s, double t) {
  return first_of(projective<false>(piece, s, t));
}

plain_second_jet evaluate_twice(const bezier_piece& piece, double s, double t) {
  const projective_jet j = projective<true>(piece, s, t);
  const plain_jet first = first_of(j);
  const double w = j.value[3];
  const auto second = [&](const plain_control& c, double w1, const plain_vector& d2, double w2,
                          const plain_vector& d1) {
    return quotient_slope(c, first.at, w) - (w1 / w) * d2 - (w2 / w) * d1;
  };
  return {first, second(j.ss, j.s[3], first.by_s, j.s[3], first.by_s),
          second(j.st, j.s[3], first.by_t, j.t[3], first.by_s),
          second(j.tt, j.t[3], first.by_t, j.t[3], first.by_t)};
}

}  // namespace asterism::internal
