// SPDX-License-Identifier: MIT
//
// Draws valid cases, points that are critical to them, and records that replay them.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "asterism/tests/oracle/oracle.hpp"
#include "generators.hpp"

namespace asterism::property {
namespace {

bool valid(const four_sites& sites) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!oracle::is_positive_definite(sites[i].metric)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (sites[i].position == sites[j].position) return false;
  }
  return true;
}

// Orders the sites so that x is on one side of the line vw and y on the other, as in a mesher's
// questions, if some order has it.
four_sites straddled(four_sites sites, random_source& random) {
  for (int attempts = 0; attempts < 8; ++attempts) {
    const auto side = [&sites](std::size_t i) {
      return oracle::orientation(sites[0].position, sites[1].position, sites[i].position);
    };
    if (to_int(side(2)) * to_int(side(3)) < 0) break;
    sites = shuffled(sites, random);
  }
  return sites;
}

void append(std::string& text, double number) {
  std::array<char, 40> buffer{};
  (void)std::snprintf(buffer.data(), buffer.size(), " %a", number);
  text += buffer.data();
}

}  // namespace

four_sites shuffled(four_sites sites, random_source& random) {
  for (int i = 3; i > 0; --i)
    std::swap(sites[static_cast<std::size_t>(i)],
              sites[static_cast<std::size_t>(random.integer(0, i))]);
  return sites;
}

four_sites draw(const kind& k, random_source& random) {
  for (int attempts = 0; attempts < 1000; ++attempts)
    if (const four_sites sites = k.attempt(random); valid(sites))
      return random.chance(4) ? sites : straddled(sites, random);
  // In practice no kind fails a thousand times. A plain square satisfies the contract if one does.
  const metric_tensor m = {1, 0, 1};
  return {site{{0, 0}, m}, site{{1, 1}, m}, site{{1, 0}, m}, site{{0, 1}, m}};
}

point draw_point(const four_sites& sites, random_source& random) {
  const point& a = sites[static_cast<std::size_t>(random.integer(0, 3))].position;
  const point& b = sites[static_cast<std::size_t>(random.integer(0, 3))].position;
  switch (random.integer(0, 4)) {
    case 0:
      return a;
    case 1:
      return {(a.x + b.x) / 2, (a.y + b.y) / 2};
    case 2:  // a whole multiple of the difference is on the line
      return {b.x + random.integer(-2, 2) * (b.x - a.x), b.y + random.integer(-2, 2) * (b.y - a.y)};
    case 3:
      return {a.x + std::round(random.real(-4, 4)), a.y + std::round(random.real(-4, 4))};
    default: {
      const double size = std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + 1e-3;
      return {a.x + random.real(-2, 2) * size, a.y + random.real(-2, 2) * size};
    }
  }
}

std::string record(std::string_view predicate, std::span<const site> sites,
                   std::span<const point> points) {
  std::string text(predicate);
  for (const site& s : sites)
    for (const double number :
         {s.position.x, s.position.y, s.metric.m11, s.metric.m12, s.metric.m22})
      append(text, number);
  for (const point& p : points)
    for (const double number : {p.x, p.y}) append(text, number);
  return text;
}

site scaled(const site& s, int coordinate_exponent, int metric_exponent) {
  const auto& [position, metric] = s;
  return {
      {std::ldexp(position.x, coordinate_exponent), std::ldexp(position.y, coordinate_exponent)},
      {std::ldexp(metric.m11, metric_exponent), std::ldexp(metric.m12, metric_exponent),
       std::ldexp(metric.m22, metric_exponent)}};
}

}  // namespace asterism::property
