// SPDX-License-Identifier: MIT
//
// States what a run with a guarantee says of its mesh: that the theorem on nets
// (docs/math/angle-theorem.md) applies to it, and at which size that came out.
#pragma once

#include <optional>

#include "asterism/core/export.h"
#include "asterism/mesh/audit/theorem_report.hpp"

namespace asterism {

// Bound of the covering radius times the factor: no point is farther from a site than the 0.75 that
// a fill keeps to, but for rounding.
inline constexpr double guaranteed_covering = 0.75 * (1 + 0x1p-20);

// Holds the numbers of a guarantee: the size factor k, sigma, eps and the bound on the number of
// sites. Lengths are metric, in the metric asked for, which is that of the mesh.
struct guarantee_claim {
  // k: edges are as many times shorter than the metric asks for.
  double size_factor = 1;
  // The variation of the field as it was sampled before the first mesh (docs/math/guarantee.md): a
  // lower bound of the field's sigma, from which the first k was chosen, and
  // nothing else.
  double field_variation = 0;
  // A bound of the field's sigma from above, between any two points whose segment is in a convex
  // polygon around the domain, or in the triangles of the mesh that the field is given on. None:
  // the field was sampled alone.
  std::optional<double> field_variation_bound = {};
  // sigma of the sites and eps, the covering radius: `variation` and `covering_radius` of the
  // hypotheses.
  double sigma = 0, eps = 0;
  // C: there are at most C times as many sites inside as any sites take that cover the domain
  // within eps. Without a bound of the field: if the field between the sites varies by no more than
  // sigma. None where the numbers give no bound.
  std::optional<double> times_least = {};
};

// Returns the claim of a mesh of which these hypotheses were measured.
ASTERISM_EXPORT guarantee_claim guarantee_of(const theorem_hypotheses& measured, double size_factor,
                                             double field_variation,
                                             const std::optional<double>& field_variation_bound);

}  // namespace asterism
