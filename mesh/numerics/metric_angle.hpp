// SPDX-License-Identifier: MIT
//
// Measures angles in a metric, in plain doubles: for reports and pictures, never for a decision
// about a mesh (the certificate tests angles exactly).
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Degrees in [0,180]: the angle at `corner` between the directions to `p` and `q` after the map
// that makes M's unit ball round, atan2(sqrt(det M) |a x b|, a^T M b). Not a number when one of the
// points is the corner.
double angle_in_metric(const metric_tensor& m, const point& corner, const point& p, const point& q);

// Returns the least of a triangle's three angles, in degrees, each angle in the metrics of all
// three vertices; for coordinates of any magnitude. The mesher ranks triangles by a faster function
// (numerics/triangle_quality.hpp), for coordinates of ordinary size.
double smallest_angle(const mesh& m, const triangle& t);

}  // namespace asterism::internal
