// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/meeting.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace asterism::internal::proof_detail {
namespace {

using whole_vector = meeting_plane::vector;

// A double as an odd whole number times a power of two.
struct odd_parts {
  std::int64_t odd = 0;
  int power = 0;

  explicit odd_parts(double x) {
    if (x == 0) return;
    odd = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &power), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(odd));
    odd /= std::int64_t{1} << zeros;
    power += zeros - 53;
  }
};

// Multiplies doubles by one power of two that makes all of them whole.
class whole_scale {
 public:
  explicit whole_scale(std::span<const double> numbers) {
    for (const double x : numbers)
      if (x != 0) least_ = std::min(least_, odd_parts(x).power);
  }
  whole operator()(double x) const {
    const odd_parts parts(x);
    return parts.odd == 0 ? whole(0) : whole(parts.odd) << (parts.power - least_);
  }

 private:
  int least_ = 2000;  // above the exponents of all doubles
};

whole_vector at_grid(const grid_point& q, const whole_vector& x, const whole_vector& y) {
  const whole scale(grid_size);  // divides x and y
  return {(q.a * x.x + q.b * y.x) / scale, (q.a * x.y + q.b * y.y) / scale};
}

// True if a polynomial, its constant first, is positive where each variable is from 0 to 1: no
// monomial is more than 1 there.
bool is_positive(std::span<const whole> p) {
  whole least = p[0];
  for (const whole& c : p.subspan(1)) least += std::min(c, whole(0));
  return least > 0;
}

bool is_positive(std::initializer_list<whole> p) {
  return is_positive(std::span<const whole>(p.begin(), p.size()));
}

bool is_zero(std::span<const whole> p) {
  return std::all_of(p.begin(), p.end(), [](const whole& c) { return c == 0; });
}

std::vector<whole> negated(std::span<const whole> p) {
  std::vector<whole> other;
  for (const whole& c : p) other.push_back(-c);
  return other;
}

using product_polynomial = std::map<std::pair<int, int>, whole>;

product_polynomial weighted_sum(const std::array<box_polynomial<whole>, 3>& excess,
                                std::span<const whole> weights) {
  product_polynomial sum;
  const std::size_t size = weight_size(weights);
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < 6; ++k)
        sum[{box_powers[i].first + box_powers[k].first,
             box_powers[i].second + box_powers[k].second}] += weights[z * size + i] * excess[z][k];
  return sum;
}

enum class sum_sign { none, negative, zero };

sum_sign sign_of(const product_polynomial& sum) {
  whole greatest = sum.at({0, 0});
  bool vanishes = greatest == 0;
  for (const auto& [power, c] : sum) {
    if (power == std::pair(0, 0)) continue;
    greatest += std::max(c, whole(0));
    vanishes = vanishes && c == 0;
  }
  return vanishes ? sum_sign::zero : greatest < 0 ? sum_sign::negative : sum_sign::none;
}

bool is_less(const site& a, const site& b) {
  return lexicographically_less(a.position, b.position);
}

// True if the rule for ties gives the edge to x and y: the greatest of the four sites is v or w,
// and the weight of v is negative, as that of w is. The four weights add up to 0, which determines
// that of v.
bool has_rule_for_edge(const meeting_sites& s, std::span<const whole> weights) {
  const site& ours = is_less(s.x, s.y) ? s.y : s.x;
  if (is_less(std::max(s.v, s.w, is_less), ours)) return false;
  const std::size_t size = weight_size(weights);
  std::vector<whole> sum;
  for (std::size_t i = 0; i < size; ++i)
    sum.push_back(weights[i] + weights[size + i] + weights[2 * size + i]);
  return is_positive(sum);
}

// True if the excess of x changes its sign across the box between two sides, that of y between the
// two others, and their gradients turn counter-clockwise everywhere: both vanish in one common
// point.
bool have_common_zero(const std::array<box_polynomial<whole>, 3>& excess) {
  const auto &x = excess[0], &y = excess[1];
  if (!is_positive({x[0], x[2], x[5]}) || !is_positive({y[0], y[1], y[3]})) return false;
  if (!is_positive({-x[0] - x[1] - x[3], -x[2] - x[4], -x[5]}) ||
      !is_positive({-y[0] - y[2] - y[5], -y[1] - y[4], -y[3]}))
    return false;
  const auto slopes = [](const box_polynomial<whole>& p) {
    std::array<whole_vector, 4> found;
    std::size_t corner = 0;
    for (const int s : {0, 1})
      for (const int t : {0, 1})
        found[corner++] = {p[1] + 2 * s * p[3] + t * p[4], p[2] + s * p[4] + 2 * t * p[5]};
    return found;
  };
  const auto of_x = slopes(x), of_y = slopes(y);
  return std::all_of(of_x.begin(), of_x.end(), [&](const whole_vector& a) {
    return std::all_of(of_y.begin(), of_y.end(),
                       [&](const whole_vector& b) { return cross(a, b) > 0; });
  });
}

}  // namespace

meeting_plane::meeting_plane(const meeting_sites& sites, const meeting_box& box) {
  const std::array<const site*, 4> all = {&sites.v, &sites.x, &sites.y, &sites.w};
  std::vector<double> places, entries;
  for (const site* s : all) {
    places.insert(places.end(), {s->position.x, s->position.y});
    entries.insert(entries.end(), {s->metric.m11, s->metric.m12, s->metric.m22});
  }
  const whole_scale of_places(places), of_entries(entries);
  constexpr int grid_bits = 26;
  for (std::size_t i = 0; i < 4; ++i) {
    const site& s = *all[i];
    sites_[i] = {{(of_places(s.position.x) - of_places(sites.v.position.x)) << grid_bits,
                  (of_places(s.position.y) - of_places(sites.v.position.y)) << grid_bits},
                 of_entries(s.metric.m11),
                 of_entries(s.metric.m12),
                 of_entries(s.metric.m22)};
  }
  const auto place = [&](const grid_point& q) { return at_grid(q, sites_[1].at, sites_[2].at); };
  const vector c1 = place(box.c1), m = place(box.m), c2 = place(box.c2);
  corners_ = {c1 + c2 - m, c1, m, c2};
  const box_polynomial<whole> own = expansion(sites_[0]);
  for (std::size_t z = 0; z < 3; ++z) {
    excess_[z] = expansion(sites_[z + 1]);
    for (std::size_t k = 0; k < 6; ++k) excess_[z][k] -= own[k];
  }
}

whole meeting_plane::product(const whole_site& of, const vector& p, const vector& q) {
  return p.x * (of.m11 * q.x + of.m12 * q.y) + p.y * (of.m12 * q.x + of.m22 * q.y);
}

box_polynomial<whole> meeting_plane::expansion(const whole_site& of) const {
  const vector from = corners_[0] - of.at, d1 = corners_[1] - corners_[0],
               d2 = corners_[3] - corners_[0];
  return {product(of, from, from), 2 * product(of, from, d1), 2 * product(of, from, d2),
          product(of, d1, d1),     2 * product(of, d1, d2),   product(of, d2, d2)};
}

// `side` is 1 for points on the left of the line from x to y, -1 for points on its right.
bool meeting_plane::is_outside(const whole_site& z, int side) const {
  const vector &x = sites_[1].at, &y = sites_[2].at;
  const auto all = [&](const auto& holds) {
    return std::all_of(corners_.begin(), corners_.end(), holds);
  };
  return all([&](const vector& p) { return side * cross(y - x, p - x) <= 0; }) ||
         all([&](const vector& p) { return side * cross(p - x, z.at - x) > 0; }) ||
         all([&](const vector& p) { return side * cross(p - y, z.at - y) < 0; });
}

bool meeting_plane::is_seen() const {
  constexpr std::array<std::pair<int, int>, 6> looks = {std::pair(0, 1), std::pair(0, 2),
                                                        std::pair(3, 1), std::pair(3, 2),
                                                        std::pair(1, 2), std::pair(2, 1)};
  for (const auto& [from, to] : looks) {
    const whole_site& a = sites_[static_cast<std::size_t>(from)];
    const vector way = sites_[static_cast<std::size_t>(to)].at - a.at;
    for (const vector& p : corners_)
      if (product(a, p - a.at, way) <= 0) return false;
  }
  // Uses that v, x, y turn counter-clockwise: v is on the left of the line from x to y.
  return is_outside(sites_[0], 1) && is_outside(sites_[3], -1);
}

bool has_meeting(const meeting_plane& plane) {
  return have_common_zero(plane.excess()) && plane.is_seen();
}

std::size_t weight_size(std::span<const whole> weights) {
  const std::size_t size = weights.size() / 3;
  return weights.size() % 3 == 0 && (size == 1 || size == 3 || size == 6) ? size : 0;
}

bool is_edge_at_meeting(const meeting_sites& sites, const meeting_box& box,
                        std::span<const whole> weights) {
  const std::size_t size = weight_size(weights);
  if (size == 0) return false;
  if (!is_positive(negated(weights.last(size)))) return false;
  const meeting_plane plane(sites, box);
  const sum_sign sign = sign_of(weighted_sum(plane.excess(), weights));
  if (sign == sum_sign::none) return false;
  for (const auto& weight : {weights.first(size), weights.subspan(size, size)})
    if (!is_positive(weight) && !(sign == sum_sign::negative && is_zero(weight))) return false;
  if (sign == sum_sign::zero && !has_rule_for_edge(sites, weights)) return false;
  return has_meeting(plane);
}

}  // namespace asterism::internal::proof_detail
