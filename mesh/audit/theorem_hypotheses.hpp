// SPDX-License-Identifier: MIT
//
// Measures whether the sites of a mesh meet the hypotheses of the theorem on nets
// (docs/math/angle-theorem.md). Then their Voronoi diagram, restricted to the domain, has only
// wedged arcs, its dual is a triangulation of the domain, and no angle of that is below
// `proved_angle` in the metric of any of its triangle's vertices. Otherwise nothing is said.
//
// Every number is rounded to the side that makes the theorem harder to apply.
#pragma once

#include "asterism/core/export.h"
#include "asterism/mesh/audit/theorem_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// Measures a mesh. Requires what points 0 to 2 of the certificate prove of it. `angle_bound` is in
// degrees; the theorem does not apply unless it proves that angle. Where neighbours in some
// triangles show that it does not apply, as their metrics differ too much or they are far too
// close, no other pairs are measured: `spacing`, `distortion` and what follows from them are then
// of these neighbours alone. Of every thousand sites, measuring stops at the first one with a near
// site whose metric differs too much for any entry of the table: then `distortion`, and the numbers
// that follow from it, are no maxima either. O(n log n) where it applies. Ended early, by `stop` or
// at the work limit for the number of sites, it returns nothing but a reason. Charges its work to
// the account of `stop`, whose limit does not end it: a measurement does not depend on earlier work
// of the run.
ASTERISM_EXPORT theorem_hypotheses measure_theorem_hypotheses(const mesh& subject,
                                                              double angle_bound,
                                                              const cancellation& stop = {});

// True if measuring was ended early.
ASTERISM_EXPORT bool is_unmeasured(const theorem_hypotheses& h);

}  // namespace asterism
