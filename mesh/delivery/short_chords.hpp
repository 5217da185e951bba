// SPDX-License-Identifier: MIT
//
// Finds chords of curves that are much shorter than edges of the metric. A mesh of unit edges
// beside them has triangles that are as narrow as the chord and as high as an edge wanted: a layer
// of needles on the curve, with hardly a vertex near it. Internal to mesh/pipeline.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal {

// Returns, for each node of the field, the factor of its tensor, at least 1, with which chords near
// it have the length 1; nothing if no chord is shorter than two fifths of an edge of the metric. A
// chord is near if one of its ends is in a triangle of the node and no farther from it than the
// chord is long: on a curve that the field's mesh follows, chords are near to the nodes on it.
// Undivided curves are left out: each is an edge of the former mesh. The time is that of locating
// the ends of chords.
std::vector<double> factors_at_short_chords(const domain& d, const background_metric& field);

}  // namespace asterism::internal
