// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/guarantee_claim.hpp"

#include <algorithm>
#include <cmath>

namespace asterism {
namespace {

// Returns C of docs/math/guarantee.md, "How many sites", rounded up, for a field that varies by no
// more than `sigma`. The disks of radius rho around the sites inside are disjoint and lie in the
// domain: no other site is nearer than the spacing over tau, and by Stewart's theorem no subsegment
// is nearer than the root of `square`.
std::optional<double> times_least(const theorem_hypotheses& h, double sigma) {
  constexpr double up = 1 + 0x1p-30;
  const double near = h.spacing / h.distortion, half = 0.5 * h.distortion * h.longest_subsegment;
  const double square = near * near - half * half;
  const double rho = std::min(
      {h.spacing / (1 + h.distortion), square > 0 ? std::sqrt(square) : 0, h.covering_radius});
  const double shrunk = 1 - sigma * rho, grown = 1 - sigma * h.covering_radius;
  if (!(rho > 0 && grown > 0 && shrunk > 0)) return std::nullopt;
  const double factor = h.covering_radius / (rho * shrunk * grown);
  const double c = factor * factor * up;
  return std::isfinite(c) ? std::optional(c) : std::nullopt;
}

}  // namespace

guarantee_claim guarantee_of(const theorem_hypotheses& measured, double size_factor,
                             double field_variation,
                             const std::optional<double>& field_variation_bound) {
  return {size_factor,
          field_variation,
          field_variation_bound,
          measured.variation,
          measured.covering_radius,
          times_least(measured, field_variation_bound.value_or(measured.variation))};
}

}  // namespace asterism
