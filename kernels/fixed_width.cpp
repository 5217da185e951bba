// SPDX-License-Identifier: MIT
//
// Widths. Integers of a question are below 2^61, their differences below 2^62. A cross product or
// M d is a sum of two products, below 2^125; u^T M d then below 2^188, a sum or difference of two
// below 2^189; the product of that with a cross product has at most 314 bits.
#include "asterism/kernels/fixed_width.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "asterism/core/plane_algebra.hpp"

namespace asterism::internal::fixed_width {

namespace {

using internal::operator-;  // of metrics, beside those of integers below

__extension__ using int128 = __int128;
__extension__ using uint128 = unsigned __int128;

template <class Integer>
sign sign_of_integer(Integer x) {
  return to_sign((x > 0) - (x < 0));
}

// A sum high 2^64 + low.
struct int192 {
  int128 high;
  std::uint64_t low;
};

int192 operator+(const int192& a, const int192& b) {
  const std::uint64_t low = a.low + b.low;
  return {a.high + b.high + (low < a.low ? 1 : 0), low};
}
int192 operator-(const int192& a) {
  return {-a.high - (a.low != 0 ? 1 : 0), std::uint64_t{0} - a.low};
}
int192 operator-(const int192& a, const int192& b) {
  return {a.high - b.high - (a.low < b.low ? 1 : 0), a.low - b.low};
}
sign sign_of_integer(const int192& a) {
  if (a.high < 0) return sign::negative;
  return a.high == 0 && a.low == 0 ? sign::zero : sign::positive;
}
int192 product(int128 a, std::int64_t b) {
  const int128 low = static_cast<int128>(static_cast<std::uint64_t>(a)) * b;
  const int128 high = static_cast<int128>(static_cast<std::int64_t>(a >> 64)) * b;
  return {high + (low >> 64), static_cast<std::uint64_t>(low)};
}

// Returns a b for a, b >= 0, the most significant limb first.
std::array<std::uint64_t, 5> product(const int192& a, int128 b) {
  const std::array<std::uint64_t, 3> left = {a.low, static_cast<std::uint64_t>(a.high),
                                             static_cast<std::uint64_t>(a.high >> 64)};
  const std::array<std::uint64_t, 2> right = {static_cast<std::uint64_t>(b),
                                              static_cast<std::uint64_t>(b >> 64)};
  std::array<std::uint64_t, 5> result{};
  for (std::size_t j = 0; j < right.size(); ++j) {
    uint128 carry = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      carry += static_cast<uint128>(left[i]) * right[j] + result[4 - (i + j)];
      result[4 - (i + j)] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    result[4 - (left.size() + j)] = static_cast<std::uint64_t>(carry);
  }
  return result;
}

// Converts the numbers to integers of one unit, each below 2^61 in size; true if all are whole
// numbers of that unit. In it the largest number has its 53 bits and 8 more below them.
template <std::size_t Count>
bool align(const std::array<double, Count>& numbers, std::array<std::int64_t, Count>& integers) {
  constexpr int fraction_bits = 52, spare_bits = 8;
  std::array<std::uint64_t, Count> fractions;
  std::array<int, Count> exponents;
  int largest = 0;
  for (std::size_t k = 0; k < Count; ++k) {
    const auto bits = std::bit_cast<std::uint64_t>(numbers[k]);
    const int biased = static_cast<int>((bits >> fraction_bits) & 0x7FF);
    const std::uint64_t hidden = biased != 0 ? std::uint64_t{1} << fraction_bits : 0;
    fractions[k] = hidden | (bits & ((std::uint64_t{1} << fraction_bits) - 1));
    exponents[k] = std::max(biased, 1);
    largest = std::max(largest, exponents[k]);
  }
  std::uint64_t lost = 0;
  for (std::size_t k = 0; k < Count; ++k) {
    const std::uint64_t full = fractions[k] << spare_bits;
    const int shift = std::min(largest - exponents[k], 63);
    const std::uint64_t size = full >> shift;
    lost |= full ^ (size << shift);
    const bool negative = (std::bit_cast<std::uint64_t>(numbers[k]) >> 63) != 0;
    integers[k] = negative ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
  }
  return lost == 0;
}

using vector = displacement<std::int64_t>;
using metric = basic_metric_tensor<std::int64_t>;

int128 multiply(std::int64_t a, std::int64_t b) { return static_cast<int128>(a) * b; }
int128 cross_product(const vector& a, const vector& b) {
  return multiply(a.x, b.y) - multiply(a.y, b.x);
}
// Returns u^T M d.
int192 inner_product(const metric& m, const vector& u, const vector& d) {
  return product(multiply(m.m11, d.x) + multiply(m.m12, d.y), u.x) +
         product(multiply(m.m12, d.x) + multiply(m.m22, d.y), u.y);
}
int192 squared_length(const metric& m, const vector& u) { return inner_product(m, u, u); }

// Coordinates of two sites and a point, as integers.
struct point_question {
  metric of_v, of_w;
  vector d, from_v, from_w;  // from v to w, and from each to the point
};

std::optional<point_question> aligned(const site& v, const site& w, const point& q) {
  std::array<std::int64_t, 6> at, m;
  if (!align<6>({v.position.x, v.position.y, w.position.x, w.position.y, q.x, q.y}, at) ||
      !align<6>(
          {v.metric.m11, v.metric.m12, v.metric.m22, w.metric.m11, w.metric.m12, w.metric.m22}, m))
    return std::nullopt;
  return point_question{{m[0], m[1], m[2]},
                        {m[3], m[4], m[5]},
                        {at[2] - at[0], at[3] - at[1]},
                        {at[4] - at[0], at[5] - at[1]},
                        {at[4] - at[2], at[5] - at[3]}};
}

// Coefficients of the difference along the ray at u from the site with metric `near`
// (predicates/domination.hpp).
struct ray {
  int192 a, half_b, c;
  ray(const metric& near, const metric& far, const vector& d, const vector& u)
      : a(squared_length(near - far, u)),
        half_b(inner_product(far, u, d)),
        c(squared_length(far, d)) {}

  bool meets_twice_up_to_end() const { return sign_of_integer(a + c) == sign::negative; }
  // True if there is certainly no root before the end, where the difference is negative.
  bool meets_never() const {
    return !meets_twice_up_to_end() || sign_of_integer(a + half_b) != sign::negative ||
           sign_of_integer(a) != sign::negative || sign_of_integer(half_b) != sign::positive;
  }
};

// Returns |a| |b| of numbers of any sign.
std::array<std::uint64_t, 5> product_of_sizes(const int192& a, int128 b) {
  return product(sign_of_integer(a) == sign::negative ? -a : a, b < 0 ? -b : b);
}

// Decides opposite_angles_value of predicates/in_circle.hpp, on four positions a, b, c, p.
sign circle_side(const metric& m, const std::array<std::int64_t, 8>& at) {
  const auto from = [&](std::size_t a, std::size_t b) {
    return vector{at[b] - at[a], at[b + 1] - at[a + 1]};
  };
  constexpr std::size_t a = 0, b = 2, c = 4, p = 6;
  const int192 at_c = inner_product(m, from(a, c), from(b, c)),
               at_p = inner_product(m, from(a, p), from(b, p));
  const int128 side_of_c = cross_product(from(a, b), from(a, c)),
               side_of_p = cross_product(from(a, b), from(a, p));
  const sign first = sign_of_integer(at_c) * sign_of_integer(side_of_p),
             second = sign_of_integer(at_p) * sign_of_integer(side_of_c);
  if (first != second) return to_sign(to_int(first) - to_int(second));
  const auto size = product_of_sizes(at_c, side_of_p), other = product_of_sizes(at_p, side_of_c);
  return size == other ? sign::zero : size > other ? first : -first;
}

enum class verdict { no, tie, yes };

// Decides predicates/insertion_test.hpp on four positions v, w, x, y.
verdict judge(const metric& m, const std::array<std::int64_t, 8>& at) {
  const vector d = {at[2] - at[0], at[3] - at[1]};
  const auto from_v = [&](std::size_t z) { return vector{at[z] - at[0], at[z + 1] - at[1]}; };
  const auto from_w = [&](std::size_t z) { return vector{at[z] - at[2], at[z + 1] - at[3]}; };
  constexpr std::size_t x = 4, y = 6;
  const vector x_from_v = from_v(x), x_from_w = from_w(x), y_from_v = from_v(y),
               y_from_w = from_w(y);
  const int128 of_x = cross_product(d, x_from_v), of_y = cross_product(d, y_from_v);
  const auto between_v_and_w = [](int128 side, const vector& a, const vector& b) {
    return side == 0 && multiply(a.x, b.x) + multiply(a.y, b.y) < 0;
  };
  if (between_v_and_w(of_x, x_from_v, x_from_w) || between_v_and_w(of_y, y_from_v, y_from_w))
    return verdict::no;
  if (of_x == 0 || of_y == 0 || (of_x > 0) == (of_y > 0)) return verdict::yes;
  // Adds the cotangents g / |o| of opposite angles: the answer is yes if the sum is above zero.
  const int192 g_x = inner_product(m, x_from_v, x_from_w),
               g_y = inner_product(m, y_from_v, y_from_w);
  const sign sign_x = sign_of_integer(g_x), sign_y = sign_of_integer(g_y);
  if (sign_x == sign::zero && sign_y == sign::zero) return verdict::tie;
  if (to_int(sign_x) + to_int(sign_y) > 0) return verdict::yes;
  if (to_int(sign_x) + to_int(sign_y) < 0) return verdict::no;
  const auto left = product_of_sizes(g_x, of_y), right = product_of_sizes(g_y, of_x);
  if (left == right) return verdict::tie;
  return ((left > right) == (sign_x == sign::positive)) ? verdict::yes : verdict::no;
}

// Decides equal_metric_tie_goes_to_edge on integers.
bool tie_goes_to_edge(const std::array<std::int64_t, 8>& at) {
  using place = std::array<std::int64_t, 2>;
  const place v = {at[0], at[1]}, w = {at[2], at[3]}, x = {at[4], at[5]}, y = {at[6], at[7]};
  return std::max(v, w) < std::max(x, y);
}

uncertain_bool insertion_answer(const site& v, const site& w, const site& x, const site& y,
                                bool break_ties) {
  std::array<std::int64_t, 8> at;
  std::array<std::int64_t, 3> m;
  if (!align<8>({v.position.x, v.position.y, w.position.x, w.position.y, x.position.x, x.position.y,
                 y.position.x, y.position.y},
                at) ||
      !align<3>({v.metric.m11, v.metric.m12, v.metric.m22}, m))
    return {};
  const verdict found = judge({m[0], m[1], m[2]}, at);
  return found == verdict::tie ? break_ties && tie_goes_to_edge(at) : found == verdict::yes;
}

}  // namespace

uncertain_sign orientation(const point& p, const point& q, const point& r) {
  std::array<std::int64_t, 6> at;
  if (!align<6>({p.x, p.y, q.x, q.y, r.x, r.y}, at)) return {};
  return sign_of_integer(
      cross_product({at[2] - at[0], at[3] - at[1]}, {at[4] - at[0], at[5] - at[1]}));
}

uncertain_bool is_positive_definite(const metric_tensor& metric) {
  std::array<std::int64_t, 3> m;
  if (!align<3>({metric.m11, metric.m12, metric.m22}, m)) return {};
  return m[0] > 0 && multiply(m[0], m[2]) > multiply(m[1], m[1]);
}

uncertain_sign in_circle(const metric_tensor& metric_of_all, const point& a, const point& b,
                         const point& c, const point& p) {
  std::array<std::int64_t, 8> at;
  std::array<std::int64_t, 3> m;
  if (!align<8>({a.x, a.y, b.x, b.y, c.x, c.y, p.x, p.y}, at) ||
      !align<3>({metric_of_all.m11, metric_of_all.m12, metric_of_all.m22}, m))
    return {};
  return circle_side({m[0], m[1], m[2]}, at);
}

uncertain_sign compare_distance(const site& v, const site& w, const point& q) {
  const auto question = aligned(v, w, q);
  if (!question) return {};
  return sign_of_integer(squared_length(question->of_v, question->from_v) -
                         squared_length(question->of_w, question->from_w));
}

uncertain_bool in_wedge(const site& v, const site& w, const point& q) {
  const auto question = aligned(v, w, q);
  if (!question) return {};
  const auto& [of_v, of_w, d, from_v, from_w] = *question;
  return sign_of_integer(inner_product(of_v, from_v, d)) == sign::positive &&
         sign_of_integer(inner_product(of_w, from_w, d)) == sign::negative;
}

uncertain_sign dominates(const site& v, const site& w, const point& p) {
  const auto question = aligned(v, w, p);
  if (!question) return {};
  const auto& [of_v, of_w, d, from_v, from_w] = *question;
  const sign nearer = sign_of_integer(squared_length(of_v, from_v) - squared_length(of_w, from_w));
  if (nearer == sign::zero) {
    const bool twice_of_v = ray(of_v, of_w, d, from_v).meets_twice_up_to_end(),
               twice_of_w = ray(of_w, of_v, -d, from_w).meets_twice_up_to_end();
    return to_sign(static_cast<int>(twice_of_w) - static_cast<int>(twice_of_v));
  }
  const ray view =
      nearer == sign::negative ? ray(of_v, of_w, d, from_v) : ray(of_w, of_v, -d, from_w);
  return view.meets_never() ? uncertain_sign(-nearer) : uncertain_sign();
}

uncertain_bool insertion_test_equal_metrics(const site& v, const site& w, const site& x,
                                            const site& y) {
  return insertion_answer(v, w, x, y, false);
}

uncertain_bool edge_test_equal_metrics(const site& v, const site& w, const site& x, const site& y) {
  return insertion_answer(v, w, x, y, true);
}

}  // namespace asterism::internal::fixed_width
