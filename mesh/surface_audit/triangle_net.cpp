// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/triangle_net.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/surface_audit/plain_net.hpp"
#include "asterism/mesh/surface_audit/ways_to_choose.hpp"

namespace asterism::internal {
namespace {

// Returns a times a weight of the polar form. With `inside` the triangle's corners are in the
// piece, so that no weight is negative and scaled() applies.
template <bool inside>
rounded_interval weighed(const rounded_interval& weight, const rounded_interval& a) {
  if constexpr (inside)
    return scaled(weight, a);
  else
    return weight * a;
}
template <bool inside>
interval_vector weighed(const rounded_interval& weight, const interval_vector& a) {
  if constexpr (inside)
    return scaled(weight, a);
  else
    return weight * a;
}

// Weights of the control points in the polar form, rows of degree + 1.
struct blossom_rows {
  std::size_t row = 1;
  std::vector<rounded_interval> weights;

  std::size_t count() const { return weights.size() / row; }
  const rounded_interval* at(std::size_t k) const { return weights.data() + k * row; }
};

// Returns, for each multi-index of sum `degree`, the weights when each corner is an argument that
// many times: the coefficients of the product of (1 - s) + s z over the arguments.
blossom_rows blossoms(int degree, const std::array<rounded_interval, 3>& at) {
  std::array<rounded_interval, 3> rest;
  for (std::size_t k = 0; k < 3; ++k) rest[k] = rounded_interval(1) - at[k];
  const std::size_t row = static_cast<std::size_t>(degree) + 1;
  std::vector<rounded_interval> lower(net_size(degree) * row), rows(lower.size());
  lower[0] = 1;
  for (int n = 1; n <= degree; ++n) {
    for (int i = n; i >= 0; --i)
      for (int j = n - i; j >= 0; --j) {
        const std::size_t corner = i > 0 ? 0 : j > 0 ? 1 : 2;
        const rounded_interval* from =
            lower.data() + row * net_index(n - 1, i - (corner == 0), j - (corner == 1));
        rounded_interval* to = rows.data() + row * net_index(n, i, j);
        const auto last = static_cast<std::size_t>(n);
        to[0] = rest[corner] * from[0];
        for (std::size_t m = 1; m < last; ++m)
          to[m] = rest[corner] * from[m] + at[corner] * from[m - 1];
        to[last] = at[corner] * from[last - 1];
      }
    lower.swap(rows);
  }
  return {row, std::move(lower)};
}

template <bool inside>
weighted_point combined(const rounded_interval* weights, const weighted_point* points,
                        std::size_t count, std::size_t stride, bool is_rational) {
  weighted_point sum{weighed<inside>(weights[0], points[0].at), 1};
  if (is_rational) sum.weight = weighed<inside>(weights[0], points[0].weight);
  for (std::size_t k = 1; k < count; ++k) {
    const weighted_point& c = points[k * stride];
    sum.at = sum.at + weighed<inside>(weights[k], c.at);
    if (is_rational) sum.weight = sum.weight + weighed<inside>(weights[k], c.weight);
  }
  return sum;
}

// Adds each pair of multi-indices of sums p and q to the multi-index that is their sum, with its
// share of the number of ways to choose it.
void gather(int p, int q, const std::vector<weighted_point>& pairs, bool is_rational,
            triangle_net& net) {
  for (int i = p; i >= 0; --i)
    for (int j = p - i; j >= 0; --j) {
      const weighted_point* row = pairs.data() + net_index(p, i, j) * net_size(q);
      const int k = p - i - j;
      for (int a = q; a >= 0; --a)
        for (int b = q - a; b >= 0; --b) {
          const int c = q - a - b;
          const rounded_interval ways =
              ways_to_choose(i + a, i) * ways_to_choose(j + b, j) * ways_to_choose(k + c, k);
          const weighted_point& from = row[net_index(q, a, b)];
          weighted_point& to = net.points[net_index(p + q, i + a, j + b)];
          to.at = to.at + scaled(ways, from.at);
          if (is_rational) to.weight = to.weight + scaled(ways, from.weight);
        }
    }
}

std::vector<weighted_point> pairs_of(const tensor_net& from, const parameter_triangle& corners,
                                     bool is_rational) {
  const auto row = static_cast<std::size_t>(from.degree_v) + 1,
             rows = static_cast<std::size_t>(from.degree_u) + 1;
  const blossom_rows by_u = blossoms(from.degree_u, {corners[0].s, corners[1].s, corners[2].s});
  const blossom_rows by_v = blossoms(from.degree_v, {corners[0].t, corners[1].t, corners[2].t});
  std::vector<weighted_point> pairs, line(row);
  pairs.reserve(by_u.count() * by_v.count());
  for (std::size_t i = 0; i < by_u.count(); ++i) {
    for (std::size_t j = 0; j < row; ++j)
      line[j] = combined<false>(by_u.at(i), from.points + j, rows, row, is_rational);
    for (std::size_t j = 0; j < by_v.count(); ++j)
      pairs.push_back(combined<false>(by_v.at(j), line.data(), row, 1, is_rational));
  }
  return pairs;
}

// Returns the weights of the first multi-index alone.
template <bool inside>
std::array<rounded_interval, most_degree + 1> first_blossom(int degree,
                                                            const rounded_interval& at) {
  const rounded_interval rest = rounded_interval(1) - at;
  std::array<rounded_interval, most_degree + 1> row;
  row[0] = 1;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(degree); ++n) {
    row[n] = weighed<inside>(at, row[n - 1]);
    for (std::size_t m = n - 1; m > 0; --m)
      row[m] = weighed<inside>(rest, row[m]) + weighed<inside>(at, row[m - 1]);
    row[0] = weighed<inside>(rest, row[0]);
  }
  return row;
}

// Multiplies by the number of ways of the first multi-index, and divides by it, so that the bits
// are those of the net.
void share_out(const tensor_net& from, weighted_point& point, bool is_rational) {
  const rounded_interval ways = ways_to_choose(from.degree_u + from.degree_v, from.degree_u);
  const rounded_interval share = quotient(rounded_interval(1), ways);
  point.at = scaled(share, scaled(ways, point.at));
  if (is_rational) point.weight = scaled(share, scaled(ways, point.weight));
}

template <bool inside>
weighted_point first_point(const tensor_net& from, const parameter_corner& at, bool is_rational) {
  const auto row = static_cast<std::size_t>(from.degree_v) + 1,
             rows = static_cast<std::size_t>(from.degree_u) + 1;
  const auto by_u = first_blossom<inside>(from.degree_u, at.s);
  const auto by_v = first_blossom<inside>(from.degree_v, at.t);
  std::array<weighted_point, most_degree + 1> line;
  for (std::size_t j = 0; j < row; ++j)
    line[j] = combined<inside>(by_u.data(), from.points + j, rows, row, is_rational);
  weighted_point point = combined<inside>(by_v.data(), line.data(), row, 1, is_rational);
  share_out(from, point, is_rational);
  return point;
}

// Converts the plain net to intervals that contain the exact one, by its bounds.
triangle_net enclosed(const plain_triangle_net& plain, bool is_rational) {
  triangle_net net{plain.degree, std::vector<weighted_point>(plain.points.size())};
  for (std::size_t k = 0; k < net.points.size(); ++k) {
    const std::array<double, 4>& c = plain.points[k];
    const double weight = is_rational ? c[3] : 1, off = rounded_product(plain.off, weight);
    const rounded_interval about(-off, off);
    net.points[k].at = {c[0] + about, c[1] + about, c[2] + about};
    if (!is_rational) continue;
    const double weight_off = rounded_product(plain.weight_off, weight);
    net.points[k].weight = weight + rounded_interval(-weight_off, weight_off);
  }
  return net;
}

bool is_inside(const parameter_triangle& corners) {
  return std::all_of(corners.begin(), corners.end(), [](const parameter_corner& c) {
    return c.s.inf() >= 0 && c.s.sup() <= 1 && c.t.inf() >= 0 && c.t.sup() <= 1;
  });
}

}  // namespace

triangle_net net_over(const tensor_net& from, const parameter_triangle& corners, bool is_rational) {
  if (const auto plain = plain_net_over(from, corners, is_rational))
    return enclosed(*plain, is_rational);
  return net_in_intervals(from, corners, is_rational);
}

triangle_net net_in_intervals(const tensor_net& from, const parameter_triangle& corners,
                              bool is_rational) {
  const int p = from.degree_u, q = from.degree_v;
  const std::vector<weighted_point> pairs = pairs_of(from, corners, is_rational);
  triangle_net net{p + q, std::vector<weighted_point>(net_size(p + q))};
  if (is_rational)
    for (weighted_point& c : net.points) c.weight = 0;
  gather(p, q, pairs, is_rational, net);
  const rounded_interval share = quotient(rounded_interval(1), ways_to_choose(p + q, p));
  for (weighted_point& c : net.points) {
    c.at = scaled(share, c.at);
    if (is_rational) c.weight = scaled(share, c.weight);
  }
  return net;
}

// Returns the net's first point, from the first multi-indices of both directions alone.
weighted_point point_at(const tensor_net& from, const parameter_corner& at, bool is_rational) {
  return is_inside({at, at, at}) ? first_point<true>(from, at, is_rational)
                                 : first_point<false>(from, at, is_rational);
}

}  // namespace asterism::internal
