// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/plain_net.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/rough_bounds.hpp"
#include "asterism/mesh/surface_audit/ways_to_choose.hpp"

namespace asterism::internal {
namespace {

using plain_control = std::array<double, 4>;

// Bounds what underflow adds, relative to a weight: weights are 2^-300 at least, and fewer than
// 2^30 products lose at most 2^-1074 each. The underflow of shares is multiplied by |P_i|, no more
// than 2^600 X w, and is within the rounding that is counted separately.
constexpr double lost_to_underflow = 0x1p-700;

// Weights of the degree + 1 control points of one direction in the polar form, a row for each
// choice of its arguments: a multi-index of sum `degree` that says how often each corner is an
// argument.
struct share_rows {
  static constexpr std::size_t most =
      net_size(most_degree) * (static_cast<std::size_t>(most_degree) + 1);
  std::size_t row = 1, count = 1;
  std::array<double, most> shares;

  const double* at(std::size_t k) const { return shares.data() + k * row; }
};

// Computes each row as the coefficients of the product of (1 - s) + s z over the arguments s of its
// multi-index.
void find_shares(int degree, const std::array<double, 3>& at, share_rows& rows) {
  rows.row = static_cast<std::size_t>(degree) + 1;
  rows.count = 0;
  for (int i = degree; i >= 0; --i)
    for (int j = degree - i; j >= 0; --j) {
      double* const to = rows.shares.data() + rows.count++ * rows.row;
      std::fill_n(to, rows.row, 0.0);
      to[0] = 1;
      for (int n = 0; n < degree; ++n) {
        const double s = at[n < i ? 0 : n < i + j ? 1 : 2], rest = 1 - s;
        for (int m = n + 1; m > 0; --m) to[m] = rest * to[m] + s * to[m - 1];
        to[0] = rest * to[0];
      }
    }
}

// Numbers on which the bounds of errors depend: |P_i| <= greatest w_i; the half-widths of control
// points and of weights, divided by w_i; the distance of the true corners from those used; and the
// ratio of weights.
struct net_facts {
  double greatest = 0, half_width = 0, weight_half_width = 0, corner_off = 0, weight_ratio = 1;
  bool usable = true;
};

struct plain_start {
  std::array<std::array<double, 3>, 2> at;  // s and t of the corners
  std::vector<plain_control> control;
  net_facts facts;
};

void take_corners(const parameter_triangle& corners, plain_start& start) {
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      const rounded_interval& x = axis == 0 ? corners[k].s : corners[k].t;
      if (!(x.inf() >= 0) || !(x.sup() <= 1)) start.facts.usable = false;
      const auto [middle, half] = parted(x);
      start.at[axis][k] = middle;
      start.facts.corner_off = std::max(start.facts.corner_off, half);
    }
}

void take_control(const tensor_net& from, bool is_rational, plain_start& start) {
  const std::size_t count =
      (static_cast<std::size_t>(from.degree_u) + 1) * (static_cast<std::size_t>(from.degree_v) + 1);
  net_facts& f = start.facts;
  start.control.resize(count);
  double least_weight = INFINITY, greatest_weight = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const weighted_point& c = from.points[k];
    const auto w = is_rational ? parted(c.weight) : middle_and_half{1, 0};
    const double least = w.middle - w.half;
    if (!(least > 0)) f.usable = false;
    least_weight = std::min(least_weight, least);
    greatest_weight = std::max(greatest_weight, w.middle + w.half);
    f.weight_half_width = std::max(f.weight_half_width, w.half / least);
    start.control[k][3] = w.middle;
    const std::array<const rounded_interval*, 3> at = {&c.at.x, &c.at.y, &c.at.z};
    for (std::size_t n = 0; n < 3; ++n) {
      const auto x = parted(*at[n]);
      start.control[k][n] = x.middle;
      f.greatest = std::max(f.greatest, (std::abs(x.middle) + x.half) / least);
      f.half_width = std::max(f.half_width, x.half / least);
    }
  }
  f.weight_ratio = greatest_weight / least_weight;
}

// Sums `count` control points, `stride` apart, by shares.
plain_control combined(const double* shares, const plain_control* points, std::size_t count,
                       std::size_t stride) {
  plain_control sum;
  for (std::size_t n = 0; n < 4; ++n) sum[n] = shares[0] * points[0][n];
  for (std::size_t k = 1; k < count; ++k)
    for (std::size_t n = 0; n < 4; ++n) sum[n] += shares[k] * points[k * stride][n];
  return sum;
}

// Adds each pair of multi-indices of sums p and q to the multi-index that is their sum, with the
// number of ways to choose it.
void sum_pairs(int p, int q, const plain_start& start, plain_triangle_net& net) {
  share_rows by_u, by_v;
  find_shares(p, start.at[0], by_u);
  find_shares(q, start.at[1], by_v);
  std::array<plain_control, most_degree + 1> line;
  std::size_t k = 0;
  for (int i = p; i >= 0; --i)
    for (int j = p - i; j >= 0; --j, ++k) {
      for (std::size_t m = 0; m < by_v.row; ++m)
        line[m] = combined(by_u.at(k), start.control.data() + m, by_u.row, by_v.row);
      std::size_t l = 0;
      for (int a = q; a >= 0; --a)
        for (int b = q - a; b >= 0; --b, ++l) {
          const plain_control pair = combined(by_v.at(l), line.data(), by_v.row, 1);
          const double ways = ways_to_choose(i + a, i) * ways_to_choose(j + b, j) *
                              ways_to_choose(p - i - j + q - a - b, p - i - j);
          plain_control& to = net.points[net_index(p + q, i + a, j + b)];
          for (std::size_t n = 0; n < 4; ++n) to[n] += ways * pair[n];
        }
    }
  const double share = 1 / ways_to_choose(p + q, p);
  for (plain_control& c : net.points)
    for (double& x : c) x *= share;
}

[[gnu::noinline]] std::optional<plain_triangle_net> to_nearest(const tensor_net& from,
                                                               const parameter_triangle& corners,
                                                               bool is_rational) {
  // Greatest relative error of weights that is accepted; if it is greater, intervals are used.
  // Below it true and computed weights differ by a factor below 1 + 2 weight_off, by which the last
  // step multiplies the errors.
  constexpr double rough = 0x1p-30;
  plain_start start;
  take_corners(corners, start);
  take_control(from, is_rational, start);
  const net_facts& f = start.facts;
  const int p = from.degree_u, q = from.degree_v;
  // Bounds the change by an argument's error. A polar form is affine in each of p + q arguments,
  // and for an argument between 0 and 1 lies between its values at 0 and 1: an argument off by h
  // changes it by at most 2 h times the greatest value.
  const double moved = 2 * (p + q) * f.corner_off * f.weight_ratio;
  if (!f.usable || !(moved + f.weight_half_width < rough)) return std::nullopt;
  plain_triangle_net net;
  net.degree = p + q;
  net.points.assign(net_size(p + q), {0, 0, 0, 0});
  sum_pairs(p, q, start, net);
  // Uses that (1 + 2^-53)^k - 1 is below (k + 1) 2^-53 for k of some hundreds.
  const double rounded = (roundings_of_net(p, q) + 1) * 0x1p-53;
  net.off = ((rounded + moved) * f.greatest + f.half_width) * slack + lost_to_underflow;
  net.weight_off =
      is_rational ? (rounded + moved + f.weight_half_width) * slack + lost_to_underflow : 0;
  // Makes both errors relative to the computed weight; so far they are relative to the true one.
  net.off *= 1 + 2 * net.weight_off, net.weight_off *= 1 + 2 * net.weight_off;
  return net;
}

}  // namespace

std::optional<plain_triangle_net> plain_net_over(const tensor_net& from,
                                                 const parameter_triangle& corners,
                                                 bool is_rational) {
  const floating_point_scope scope(rounding::nearest);
  return to_nearest(from, corners, is_rational);
}

}  // namespace asterism::internal
