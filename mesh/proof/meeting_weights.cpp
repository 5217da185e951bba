// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/meeting_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asterism::internal::proof_detail {
namespace {

using polynomial = box_polynomial<rational>;  // also in other variables than s and t
using affine = std::array<rational, 3>;       // 1, s, t

rational value_at(const polynomial& p, const rational& s, const rational& t) {
  return p[0] + s * (p[1] + s * p[3] + t * p[4]) + t * (p[2] + t * p[5]);
}

// Returns p with the affine functions a and b in place of its two variables.
polynomial substituted(const polynomial& p, const affine& a, const affine& b) {
  polynomial q{};
  q[0] = p[0];
  for (std::size_t i = 0; i < 3; ++i) q[i] += p[1] * a[i] + p[2] * b[i];
  const auto add_product = [&](const rational& k, const affine& f, const affine& g) {
    q[0] += k * f[0] * g[0];
    q[1] += k * (f[0] * g[1] + f[1] * g[0]);
    q[2] += k * (f[0] * g[2] + f[2] * g[0]);
    q[3] += k * f[1] * g[1];
    q[4] += k * (f[1] * g[2] + f[2] * g[1]);
    q[5] += k * f[2] * g[2];
  };
  add_product(p[3], a, a);
  add_product(p[4], a, b);
  add_product(p[5], b, b);
  return q;
}

whole rounded(const rational& x) {
  const whole top = 2 * numerator(x) + denominator(x), bottom = 2 * denominator(x);
  whole quotient = top / bottom;
  if (top < 0 && quotient * bottom != top) --quotient;
  return quotient;
}

rational rounded_to(const rational& x, int bits) {
  const whole unit = whole(1) << bits;
  return rational(rounded(x * rational(unit)), unit);
}

using excesses = std::array<polynomial, 3>;  // of x, y and w

// The point of the box where the excesses of x and y vanish, to within 2^-160 of the box's sides.
struct box_point {
  rational s, t;
};

std::optional<box_point> common_zero(const excesses& g) {
  constexpr int steps = 12, bits = 160;
  box_point z{rational(1, 2), rational(1, 2)};
  for (int i = 0; i < steps; ++i) {
    std::array<rational, 2> value, by_s, by_t;
    for (std::size_t k = 0; k < 2; ++k) {
      value[k] = value_at(g[k], z.s, z.t);
      by_s[k] = g[k][1] + 2 * z.s * g[k][3] + z.t * g[k][4];
      by_t[k] = g[k][2] + z.s * g[k][4] + 2 * z.t * g[k][5];
    }
    const rational area = by_s[0] * by_t[1] - by_s[1] * by_t[0];
    if (area == 0) return std::nullopt;
    z.s = rounded_to(z.s - (value[0] * by_t[1] - value[1] * by_t[0]) / area, bits);
    z.t = rounded_to(z.t - (by_s[0] * value[1] - by_s[1] * value[0]) / area, bits);
    if (abs(z.s) > 4 || abs(z.t) > 4) return std::nullopt;
  }
  return z;
}

// New variables about a point of the box: u and w are the linear parts of the excesses of x and y.
struct frame {
  affine u, w;  // by s and t
  affine s, t;  // by u and w
};

std::optional<frame> frame_at(const excesses& g, const box_point& z) {
  std::array<affine, 2> rows;
  for (std::size_t k = 0; k < 2; ++k) {
    const rational by_s = g[k][1] + 2 * z.s * g[k][3] + z.t * g[k][4],
                   by_t = g[k][2] + z.s * g[k][4] + 2 * z.t * g[k][5];
    rows[k] = {-by_s * z.s - by_t * z.t, by_s, by_t};
  }
  const rational area = rows[0][1] * rows[1][2] - rows[0][2] * rows[1][1];
  if (area == 0) return std::nullopt;
  return frame{rows[0],
               rows[1],
               {z.s, rows[1][2] / area, -rows[0][2] / area},
               {z.t, -rows[1][1] / area, rows[0][1] / area}};
}

// Returns weights, as polynomials in s and t, with which the weighted sum of the three excesses is
// constant, up to terms of order 3, or of order 4 for degree 2. The constant is the excess of w at
// the point, up to its sign. With g_x = u + ..., g_y = w + ... and g_w = a u + b w + ... the
// weights begin with a, b and -1; each further degree removes the terms of the next order from the
// sum.
excesses near_weights(const excesses& g, const frame& f, int degree) {
  excesses of;
  for (std::size_t k = 0; k < 3; ++k) of[k] = substituted(g[k], f.s, f.t);
  excesses weights{};
  weights[0][0] = of[2][1];
  weights[1][0] = of[2][2];
  weights[2][0] = -1;
  polynomial second{};
  for (std::size_t i = 3; i < 6; ++i)
    second[i] = of[2][1] * of[0][i] + of[2][2] * of[1][i] - of[2][i];
  const rational half(1, 2);
  weights[0][1] = -second[3];
  weights[0][2] = weights[1][1] = -half * second[4];
  weights[1][2] = -second[5];
  if (degree == 2) {
    std::array<rational, 4> third{};  // of uuu, uuw, uww, www
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        third[i] += weights[k][1] * of[k][3 + i];
        third[i + 1] += weights[k][2] * of[k][3 + i];
      }
    weights[0][3] = -third[0];
    weights[0][4] = -third[1];
    weights[0][5] = weights[1][4] = -half * third[2];
    weights[1][5] = -third[3];
  }
  for (polynomial& weight : weights) weight = substituted(weight, f.u, f.w);
  return weights;
}

std::vector<whole> with_digits(const excesses& weights, std::size_t size, int bits) {
  rational greatest = 0;
  for (const polynomial& weight : weights)
    for (std::size_t i = 0; i < size; ++i) greatest = std::max<rational>(greatest, abs(weight[i]));
  std::vector<whole> found;
  if (greatest == 0) return found;
  const rational scale = rational(whole(1) << bits) / greatest;
  for (const polynomial& weight : weights)
    for (std::size_t i = 0; i < size; ++i) found.push_back(rounded(weight[i] * scale));
  return found;
}

std::optional<std::vector<whole>> near_meeting(const meeting_sites& sites, const meeting_box& box,
                                               const excesses& g, const box_point& z) {
  // Tries the weight of w alone first: away from ties w is farther than v from the whole box.
  std::vector<whole> alone = {0, 0, -1};
  if (is_edge_at_meeting(sites, box, alone)) return alone;
  const auto f = frame_at(g, z);
  if (!f) return std::nullopt;
  for (const int degree : {1, 2}) {
    const excesses weights = near_weights(g, *f, degree);
    for (const int bits : {40, 64, 96, 128, 192}) {
      auto found = with_digits(weights, degree == 1 ? 3 : 6, bits);
      if (is_edge_at_meeting(sites, box, found)) return found;
    }
  }
  return std::nullopt;
}

using row = std::vector<rational>;

// Brings a matrix into reduced echelon form and returns the columns of its pivots.
std::vector<std::size_t> reduce(std::vector<row>& matrix) {
  std::vector<std::size_t> pivots;
  const std::size_t columns = matrix.front().size();
  for (std::size_t c = 0; c < columns && pivots.size() < matrix.size(); ++c) {
    const std::size_t top = pivots.size();
    std::size_t r = top;
    while (r < matrix.size() && matrix[r][c] == 0) ++r;
    if (r == matrix.size()) continue;
    std::swap(matrix[r], matrix[top]);
    const rational pivot = matrix[top][c];
    for (rational& x : matrix[top]) x /= pivot;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      const rational factor = matrix[i][c];
      if (i == top || factor == 0) continue;
      for (std::size_t k = c; k < columns; ++k) matrix[i][k] -= factor * matrix[top][k];
    }
    pivots.push_back(c);
  }
  return pivots;
}

// Scales the weights, which are rationals, to whole numbers without a common divisor, with the sign
// that makes w's weight, the last of the three, negative at the point z of the box.
std::vector<whole> in_lowest_terms(const row& weights, const box_point& z) {
  whole multiple = 1, divisor = 0;
  for (const rational& x : weights) multiple = lcm(multiple, denominator(x));
  std::vector<whole> found;
  for (const rational& x : weights) {
    found.push_back(numerator(x) * (multiple / denominator(x)));
    divisor = gcd(divisor, found.back());
  }
  const std::size_t size = weights.size() / 3;
  polynomial last{};
  for (std::size_t i = 0; i < size; ++i) last[i] = rational(found[2 * size + i]);
  if (value_at(last, z.s, z.t) > 0) divisor = -divisor;
  if (divisor != 0)
    for (whole& x : found) x /= divisor;
  return found;
}

// True for the coefficients that can be brought to 0 by adding multiples of one excess to the
// weight of another: those of s and t in w's weight, and that of s in y's. The sides of the box are
// nearly along the bisectors, so that the excess of x grows by s, and that of y by t.
bool is_of_multiples(std::size_t column, std::size_t size) {
  const std::size_t z = column / size, i = column % size;
  return (z == 2 && (i == 1 || i == 2)) || (z == 1 && i == 1);
}

// Returns a basis of the weights of this size with which the weighted sum vanishes altogether. With
// `is_reduced` the coefficients for which is_of_multiples() holds are zero.
std::vector<row> vanishing_weights(const excesses& g, std::size_t size, bool is_reduced) {
  const int degree = size == 1 ? 2 : size == 3 ? 3 : 4;
  std::vector<std::pair<int, int>> monomials;
  for (int i = 0; i <= degree; ++i)
    for (int k = 0; i + k <= degree; ++k) monomials.emplace_back(i, k);
  std::vector<row> matrix(monomials.size(), row(3 * size, rational(0)));
  for (std::size_t r = 0; r < monomials.size(); ++r)
    for (std::size_t z = 0; z < 3; ++z)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < 6; ++k)
          if (monomials[r] == std::pair(box_powers[i].first + box_powers[k].first,
                                        box_powers[i].second + box_powers[k].second) &&
              !(is_reduced && is_of_multiples(z * size + i, size)))
            matrix[r][z * size + i] = g[z][k];
  const std::vector<std::size_t> pivots = reduce(matrix);
  std::vector<row> basis;
  for (std::size_t c = 0; c < 3 * size; ++c) {
    if (std::find(pivots.begin(), pivots.end(), c) != pivots.end()) continue;
    if (is_reduced && is_of_multiples(c, size)) continue;
    row& one = basis.emplace_back(3 * size, rational(0));
    one[c] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) one[pivots[i]] = -matrix[i][c];
  }
  return basis;
}

std::optional<std::vector<whole>> exact_meeting(const meeting_sites& sites, const meeting_box& box,
                                                const excesses& g, const box_point& z) {
  for (const auto& [size, is_reduced] :
       {std::pair(1, false), std::pair(3, false), std::pair(3, true), std::pair(6, true)})
    for (const row& weights : vanishing_weights(g, static_cast<std::size_t>(size), is_reduced)) {
      auto found = in_lowest_terms(weights, z);
      if (is_edge_at_meeting(sites, box, found)) return found;
    }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<whole>> find_weights(const meeting_sites& sites, const meeting_box& box) {
  const meeting_plane plane(sites, box);
  if (!has_meeting(plane)) return std::nullopt;
  excesses g;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 6; ++i) g[k][i] = rational(plane.excess()[k][i]);
  const auto z = common_zero(g);
  if (!z) return std::nullopt;
  const rational left = abs(value_at(g[2], z->s, z->t)), change = abs(g[2][1]) + abs(g[2][2]);
  // Uses that a common point of all four bisectors is found to 2^-160, whereas bisectors without
  // one are farther apart, as sites and tensors are doubles.
  const rational nothing(whole(1), whole(1) << 120);
  return left < change * nothing ? exact_meeting(sites, box, g, *z)
                                 : near_meeting(sites, box, g, *z);
}

}  // namespace asterism::internal::proof_detail
