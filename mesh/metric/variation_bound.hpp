// SPDX-License-Identifier: MIT
//
// Bounds how fast a metric field varies: its sigma (docs/math/guarantee.md, "The field's sigma").
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Bounds the least sigma with H1 between any two points whose segment is in the region: a convex
// polygon around the domain, with sixteen sides at most, for a formula; the triangles of the
// background that meet it for a field that is given on a mesh.
struct variation_bounds {
  // No less than the field varies anywhere in the region. None where none was found.
  std::optional<double> above;
  // About what it varies by at the steepest place that was found: no bound rests on it.
  double seen = 0;
  std::string obstacle;  // in half a sentence, why there is no bound
};

// Encloses the field over boxes and triangles, and halves those that vary most until the bound is
// within 2 % of what is seen, or 200,000 parts have been looked at. Roundings of the field's own
// doubles are left aside: they have no derivative. Requires a domain with vertices.
variation_bounds bound_variation(const domain& d, const metric_field& field);

}  // namespace asterism::internal
