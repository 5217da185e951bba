// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/gap_row.hpp"

#include <algorithm>
#include <limits>

namespace asterism::internal::proof_detail {
namespace {

// True if the points are on the rays and between them, counter-clockwise: decided in integers,
// since y is to the left of x.
bool is_in_order(const gap_row& row) {
  const auto& p = row.points;
  if (p.size() < 2 || p.size() > most_points || row.turn >= p.size()) return false;
  if (p.front().b != 0 || p.back().a != 0) return false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].a < 0 || p[i].b < 0 || p[i].a + p[i].b == 0) return false;
    if (i > 0 && p[i - 1].a * p[i].b < p[i - 1].b * p[i].a) return false;
  }
  return true;
}

bool are_on_one_ray(const grid_point& p, const grid_point& q) { return p.a * q.b == p.b * q.a; }

// Decides condition(region), with room for three points only if the row has no more.
template <class Condition>
bool decide_of(const gap_sites& g, const gap_row& row, const Condition& condition) {
  return decide([&](auto zero) -> uncertain_bool {
    using number = decltype(zero);
    if (row.points.size() == 3) return condition(make_region<number, 3>(g.v, g.x, g.y, row.points));
    return condition(make_region<number, most_points>(g.v, g.x, g.y, row.points));
  });
}

template <class Number, std::size_t Capacity>
Number number_of(const gap_region<Number, Capacity>&, double value) {
  return Number(value);
}

}  // namespace

bool is_sound(const gap_sites& g, const gap_row& row) {
  return is_in_order(row) && decide_of(g, row, [&](const auto& r) {
           uncertain_bool sound = true;
           for (std::size_t i = 0; i + 1 < r.count && !sound.certainly(false); ++i)
             if (!are_on_one_ray(row.points[i], row.points[i + 1]))
               sound = sound & (i < row.turn ? is_behind(r, i, r.x, g.v, g.x)
                                             : is_behind(r, i, r.y, g.v, g.y));
           return sound;
         });
}

bool is_within(const gap_sites& g, const gap_row& row, double squared_radius) {
  return decide_of(g, row, [&](const auto& r) {
    const auto radius = number_of(r, squared_radius);
    uncertain_bool within = reaches_zero(radius - r.on_x) & reaches_zero(radius - r.on_y);
    for (std::size_t i = 0; i < r.count; ++i) within = within & reaches_zero(radius - r.own[i]);
    return within;
  });
}

double squared_reach(const gap_sites& g, const gap_row& row) {
  const auto r = make_region<bounded, most_points>(g.v, g.x, g.y, row.points);
  double reach = std::max(r.on_x.upper(), r.on_y.upper());
  for (std::size_t i = 0; i < r.count; ++i) reach = std::max(reach, r.own[i].upper());
  return reach <= std::numeric_limits<double>::max() ? reach
                                                     : std::numeric_limits<double>::infinity();
}

bool refuses(const gap_sites& g, const gap_row& row, const site& w) {
  return decide_of(g, row, [&](const auto& r) { return is_refused(r, g.v, w); });
}

bool refuses_but_at_turn(const gap_sites& g, const gap_row& row, const site& w) {
  if (row.turn < 1 || row.turn + 1 >= row.points.size()) return false;
  std::vector<grid_point> points(row.points.begin(), row.points.end());
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(row.turn));
  return refuses(g, {points, row.turn}, w);
}

void gap_rows::set(std::uint32_t gap, const proof_exception& row) {
  plain_[gap] = {};
  wide_[gap] = {points_of(row), row.turn};
}

std::vector<grid_point> points_of(const proof_exception& exception) {
  std::vector<grid_point> points;
  for (const proof_point& p : exception.points) points.push_back(as_grid_point(p));
  return points;
}

}  // namespace asterism::internal::proof_detail
