// SPDX-License-Identifier: MIT
//
// Bounds how fast a metric field varies: its sigma (docs/math/guarantee.md, "The field's sigma").
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// Bound of the least sigma with which hypothesis H1 holds between any two points whose segment is
// in the region: a convex polygon around the domain, with sixteen sides at most, for a formula; the
// triangles of the background that meet it for a field that is given on a mesh.
struct variation_bounds {
  // Upper bound of the field's variation in the region. None where none was found.
  std::optional<double> above;
  // Approximate variation at the steepest place that was found: no bound depends on it.
  double seen = 0;
  std::string obstacle;  // in half a sentence, why there is no bound
};

// Encloses the field over boxes and triangles, and halves those that vary most until the bound is
// within 2 % of the variation seen, or 200,000 parts were bounded. Roundings of the field's own
// doubles are ignored: they have no derivative. Requires a domain with vertices.
variation_bounds bound_variation(const domain& d, const metric_field& field);

}  // namespace asterism::internal
