// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/unit_subject.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal::audit_detail {
namespace {

// Exponents within which products of four numbers, as bounds of distances have them, are far from
// the ends of the range of doubles, 2^-1022 and 2^1024.
constexpr int ordinary = 100;

bool is_ordinary(int exponent) { return exponent >= -ordinary && exponent <= ordinary; }

// Multiplies a number by 2^exponent; returns false if that loses bits.
bool multiply(double& x, int exponent) {
  const double before = x;
  x = std::ldexp(x, exponent);
  return before == 0 || std::isnormal(x);
}

struct sizes {
  double coordinate = 0, metric = 0;  // the greatest of all
};

sizes sizes_of(const mesh& subject) {
  sizes all;
  for (const site& s : subject.sites) {
    all.coordinate = std::max({all.coordinate, std::abs(s.position.x), std::abs(s.position.y)});
    all.metric = std::max({all.metric, s.metric.m11, s.metric.m22});
  }
  return all;
}

}  // namespace

double power_of_extreme(double size) {
  constexpr int most = 1000;  // a power that is a normal double, and so is its inverse
  if (!(size > 0 && std::isfinite(size))) return 1;
  const int exponent = std::ilogb(size);
  return is_ordinary(exponent) ? 1 : std::ldexp(1.0, std::clamp(-exponent, -most, most));
}

std::optional<unit_subject> unit_subject_of(const mesh& subject) {
  const sizes all = sizes_of(subject);
  if (!(all.coordinate > 0 && all.metric > 0 && std::isfinite(all.coordinate) &&
        std::isfinite(all.metric)))
    return std::nullopt;
  const int of_coordinate = std::ilogb(all.coordinate), of_metric = std::ilogb(all.metric);
  if (is_ordinary(of_coordinate) && is_ordinary(of_metric)) return std::nullopt;
  const int half = of_metric / 2;  // metrics are multiplied by powers of four
  if (!std::isnormal(std::ldexp(1.0, of_coordinate + half))) return std::nullopt;
  unit_subject scaled{subject, of_coordinate + half};
  for (site& s : scaled.image.sites)
    for (const auto& [x, exponent] : {std::pair{&s.position.x, of_coordinate},
                                      {&s.position.y, of_coordinate},
                                      {&s.metric.m11, 2 * half},
                                      {&s.metric.m12, 2 * half},
                                      {&s.metric.m22, 2 * half}})
      if (!multiply(*x, -exponent)) return std::nullopt;
  return scaled;
}

}  // namespace asterism::internal::audit_detail
