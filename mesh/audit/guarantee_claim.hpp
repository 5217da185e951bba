// SPDX-License-Identifier: MIT
//
// States the claim of a run with a guarantee: that the theorem on nets (docs/math/angle-theorem.md)
// applies to its mesh, and the size factor with which that was reached.
#pragma once

#include <optional>

#include "asterism/core/export.h"
#include "asterism/mesh/audit/theorem_report.hpp"

namespace asterism {

// Upper bound of the covering radius times the size factor: a fill leaves no point farther than
// 0.75 from a site, but for rounding.
inline constexpr double guaranteed_covering = 0.75 * (1 + 0x1p-20);

// Holds the numbers of a guarantee: the size factor k, sigma, eps and the bound on the number of
// sites. Lengths are in the metric asked for, which is the mesh's metric.
struct guarantee_claim {
  // Size factor k: edges are k times shorter than the metric asks for.
  double size_factor = 1;
  // Sampled variation of the field before the first mesh (docs/math/guarantee.md): a lower
  // bound of the field's sigma. The first k was chosen from it; nothing else depends on
  // it.
  double field_variation = 0;
  // Upper bound of the field's sigma between any two points whose segment is in a convex polygon
  // around the domain, or in the triangles of the mesh that the field is given on. None if the
  // field was sampled alone.
  std::optional<double> field_variation_bound = {};
  // Measured sigma of the sites and eps, their covering radius: `variation` and `covering_radius`
  // of the hypotheses.
  double sigma = 0, eps = 0;
  // Bound C on the number of sites: there are at most C times as many sites inside as any set of
  // sites has that covers the domain within eps. If the field has no bound, it holds for a field
  // that varies by no more than sigma between the sites. None where the numbers give no bound.
  std::optional<double> times_least = {};
};

// Returns the claim of a mesh whose hypotheses were measured as given.
ASTERISM_EXPORT guarantee_claim guarantee_of(const theorem_hypotheses& measured, double size_factor,
                                             double field_variation,
                                             const std::optional<double>& field_variation_bound);

}  // namespace asterism
