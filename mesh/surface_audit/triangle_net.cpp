// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/triangle_net.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t most_row = most_degree + 1;
using blossom_row = std::array<rounded_interval, most_row>;

constexpr std::array<std::array<double, 2 * most_degree + 1>, 2 * most_degree + 1> binomials() {
  std::array<std::array<double, 2 * most_degree + 1>, 2 * most_degree + 1> c{};
  for (std::size_t n = 0; n < c.size(); ++n) {
    c[n][0] = 1;
    for (std::size_t k = 1; k <= n; ++k) c[n][k] = c[n - 1][k - 1] + (k < n ? c[n - 1][k] : 0);
  }
  return c;
}
// Exact: the greatest, C(24, 12), is far below 2^53.
constexpr auto binomial = binomials();

double choose(int n, int k) {
  return binomial[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

// Returns, for each multi-index of sum `degree`, the weights that the polar form gives to the
// control points when its arguments are the corners so many times: the coefficients of the product
// of (1 - s) + s z over the arguments.
std::vector<blossom_row> blossoms(int degree, const std::array<rounded_interval, 3>& at) {
  std::array<rounded_interval, 3> rest;
  for (std::size_t k = 0; k < 3; ++k) rest[k] = rounded_interval(1) - at[k];
  std::vector<blossom_row> lower(1), rows;
  lower[0][0] = 1;
  for (int n = 1; n <= degree; ++n) {
    rows.assign(net_size(n), {});
    for (int i = n; i >= 0; --i)
      for (int j = n - i; j >= 0; --j) {
        const std::size_t corner = i > 0 ? 0 : j > 0 ? 1 : 2;
        const blossom_row& from = lower[net_index(n - 1, i - (corner == 0), j - (corner == 1))];
        blossom_row& to = rows[net_index(n, i, j)];
        to[0] = rest[corner] * from[0];
        for (std::size_t m = 1; m < static_cast<std::size_t>(n); ++m)
          to[m] = rest[corner] * from[m] + at[corner] * from[m - 1];
        to[static_cast<std::size_t>(n)] = at[corner] * from[static_cast<std::size_t>(n) - 1];
      }
    lower.swap(rows);
  }
  return lower;
}

weighted_point combined(const rounded_interval* weights, const weighted_point* points,
                        std::size_t count, std::size_t stride, bool is_rational) {
  weighted_point sum{weights[0] * points[0].at,
                     is_rational ? weights[0] * points[0].weight : rounded_interval(1)};
  for (std::size_t k = 1; k < count; ++k) {
    sum.at = sum.at + weights[k] * points[k * stride].at;
    if (is_rational) sum.weight = sum.weight + weights[k] * points[k * stride].weight;
  }
  return sum;
}

// The pairs of multi-indices of sums p and q are as many as the products of their numbers; each
// adds to the multi-index that is their sum, with the share of the ways to choose it.
void gather(int p, int q, const std::vector<weighted_point>& pairs, bool is_rational,
            triangle_net& net) {
  for (int i = p; i >= 0; --i)
    for (int j = p - i; j >= 0; --j) {
      const weighted_point* row = pairs.data() + net_index(p, i, j) * net_size(q);
      const int k = p - i - j;
      for (int a = q; a >= 0; --a)
        for (int b = q - a; b >= 0; --b) {
          const int c = q - a - b;
          const rounded_interval ways = choose(i + a, i) * choose(j + b, j) * choose(k + c, k);
          const weighted_point& from = row[net_index(q, a, b)];
          weighted_point& to = net.points[net_index(p + q, i + a, j + b)];
          to.at = to.at + ways * from.at;
          if (is_rational) to.weight = to.weight + ways * from.weight;
        }
    }
}

}  // namespace

triangle_net net_over(const tensor_net& from, const parameter_triangle& corners, bool is_rational) {
  const int p = from.degree_u, q = from.degree_v;
  const auto row = static_cast<std::size_t>(q) + 1, rows = static_cast<std::size_t>(p) + 1;
  const auto by_u = blossoms(p, {corners[0].s, corners[1].s, corners[2].s});
  const auto by_v = blossoms(q, {corners[0].t, corners[1].t, corners[2].t});
  std::vector<weighted_point> pairs, line(row);
  pairs.reserve(by_u.size() * by_v.size());
  for (const blossom_row& across : by_u) {
    for (std::size_t j = 0; j < row; ++j)
      line[j] = combined(across.data(), from.points + j, rows, row, is_rational);
    for (const blossom_row& weights : by_v)
      pairs.push_back(combined(weights.data(), line.data(), row, 1, is_rational));
  }
  triangle_net net{p + q, std::vector<weighted_point>(net_size(p + q))};
  if (is_rational)
    for (weighted_point& c : net.points) c.weight = 0;
  gather(p, q, pairs, is_rational, net);
  const rounded_interval share = quotient(rounded_interval(1), choose(p + q, p));
  for (weighted_point& c : net.points)
    c = {share * c.at, is_rational ? share * c.weight : rounded_interval(1)};
  return net;
}

}  // namespace asterism::internal
