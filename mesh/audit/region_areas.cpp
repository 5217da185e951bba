// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/region_areas.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "asterism/core/dyadic.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism {
namespace {

using internal::dyadic;
using exact_areas = std::map<int, dyadic>;  // twice the areas

// Returns the double nearest to a rational. Divides to 64 bits and sets the last one if a remainder
// is left, so that rounding to 53 bits meets no false tie.
double nearest_double(const dyadic& x) {
  if (x.is_zero()) return 0;
  constexpr long limb_bits = 64;
  const auto limbs = x.mantissa().limbs();
  const int zeros = std::countl_zero(limbs.back());
  std::uint64_t leading = limbs.back() << zeros;
  if (zeros > 0 && limbs.size() > 1) leading |= limbs[limbs.size() - 2] >> (limb_bits - zeros);
  const long length = x.mantissa().bit_length(), left_out = length - limb_bits;
  if (left_out > static_cast<long>(x.mantissa().trailing_zeros())) leading |= 1;
  constexpr long most = 5000;  // beyond the exponents of all doubles
  const long exponent = std::clamp(x.exponent() + left_out, -most, most);
  const double magnitude = std::ldexp(static_cast<double>(leading), static_cast<int>(exponent));
  return x.sign_value() == sign::negative ? -magnitude : magnitude;
}

dyadic doubled_area(const point& a, const point& b, const point& c) {
  const dyadic ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

bool is_finite(const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool can_be_measured(const mesh& m, const triangle& t) {
  return std::all_of(t.begin(), t.end(), [&m](vertex_index v) {
    return v < m.sites.size() && is_finite(m.sites[v].position);
  });
}

exact_areas sum_of_triangles(const mesh& m, std::size_t begin, std::size_t end) {
  exact_areas sums;
  for (std::size_t i = begin; i < end; ++i) {
    const triangle& t = m.triangles[i];
    if (!can_be_measured(m, t)) continue;
    dyadic& sum = sums[i < m.regions.size() ? m.regions[i] : 1];
    sum =
        sum + doubled_area(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position);
  }
  return sums;
}

areas_by_region rounded(const exact_areas& doubled) {
  areas_by_region areas;
  for (const auto& [region, sum] : doubled) areas[region] = nearest_double(sum.scaled(-1));
  return areas;
}

}  // namespace

areas_by_region areas_of_regions(const mesh& m) {
  constexpr std::size_t chunk = 4096;
  const auto parts = internal::map_chunks<exact_areas>(
      m.triangles.size(), chunk,
      [&m](std::size_t begin, std::size_t end) { return sum_of_triangles(m, begin, end); });
  exact_areas all;
  for (const exact_areas& part : parts)
    for (const auto& [region, sum] : part) {
      dyadic& whole = all[region];
      whole = whole + sum;
    }
  return rounded(all);
}

areas_by_region areas_of_regions(const domain& d) {
  exact_areas sums;
  const auto is_there = [&d](vertex_index v) {
    return v < d.vertices.size() && is_finite(d.vertices[v]);
  };
  for (const segment& s : d.segments) {
    if (!is_there(s.a) || !is_there(s.b)) continue;
    const point &a = d.vertices[s.a], &b = d.vertices[s.b];
    const dyadic part = dyadic(a.x) * dyadic(b.y) - dyadic(a.y) * dyadic(b.x);
    dyadic& left = sums[s.left_region];
    left = left + part;
    if (!s.internal) continue;
    dyadic& right = sums[s.right_region];
    right = right - part;
  }
  return rounded(sums);
}

std::vector<region_area> measure_regions(const mesh& m, const domain* original) {
  const bool plain_mesh =
      std::all_of(m.regions.begin(), m.regions.end(), [](int region) { return region == 1; });
  const bool plain_domain =
      original == nullptr ||
      std::all_of(original->segments.begin(), original->segments.end(), [](const segment& s) {
        return s.left_region == 1 && (!s.internal || s.right_region == 1);
      });
  if (plain_mesh && plain_domain) return {};
  std::map<int, region_area> found;
  for (const auto& [region, area] : areas_of_regions(m)) found[region].mesh = area;
  if (original != nullptr)
    for (const auto& [region, area] : areas_of_regions(*original)) found[region].domain = area;
  std::vector<region_area> regions;
  for (auto& [region, areas] : found) {
    areas.number = region;
    if (original != nullptr && !areas.domain) areas.domain = 0;
    regions.push_back(areas);
  }
  return regions;
}

}  // namespace asterism
