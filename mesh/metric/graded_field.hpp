// SPDX-License-Identifier: MIT
//
// Makes a metric field change slowly in its own lengths (metric gradation).
//
// With sigma = ln(beta), each metric is intersected with what every other allows at its place,
//     M_q <- M_q ∩ (1 + sigma d_p(q))^-2 M_p,   d_p(q) the distance from p to q as p measures it
// (the intersection is that of numerics/metric_algebra.hpp, which never makes the shortest length
// shorter): a length wanted at p grows to at most 1 + sigma d times as much at distance d. Where a
// field is graded, neighbouring edges differ by a factor of about beta, and the distortion between
// p and q is at most 1 / (1 - sigma d_p(q)): the hypothesis H1 of docs/math/refinement.md. Source:
// Alauzet, "Size gradation control of anisotropic meshes", Finite Elements in Analysis and Design
// 46, 2010.
//
// How: the field is sampled on an adaptive grid over the box (gradation/gradation_grid.hpp), nodes
// are intersected with the limits of neighbouring nodes and of eight points at distance 1 in their
// own metric, until nothing changes, and the grid is refined where the result is not yet resolved.
// Between the nodes logarithms are interpolated. Metrics only grow, and no eigenvalue grows above
// the largest in the box: the sweeps end, and their number is bounded as well.
//
// Guaranteed: no node is coarser than the field as given, every value is positive definite, the
// same input gives the same field, and where no node of a triangle of the grid was changed the
// field as given is returned itself. Not guaranteed: the growth is bounded up to the slack of the
// sweeps and the resolution of the grid (a fifth more than sigma in all but some pairs of points in
// a thousand, the tests measure it); between nodes a length may come out some percent longer than
// given; a feature narrower than a 32nd of the box that no sample hits is missed. For beta below
// about 1.02 the slack, 0.03 of the square of a length at distance 1, is more than sigma allows,
// and bounds the growth instead. Outside the box the field is that of the nearest point of its
// border.
#pragma once

#include <memory>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/gradation/gradation_options.hpp"

namespace asterism {

// The graded field, and the report of its gradation.
struct graded_metric {
  std::unique_ptr<metric_field> field;
  gradation_report report;
};

// Grades `field`, and returns it unchanged if no node was changed. `box` is that of the domain.
// Fails where the field does anywhere in the box, inside the domain or not, for options out of
// range, and when it was stopped.
ASTERISM_EXPORT result<graded_metric> grade_metric(std::unique_ptr<metric_field> field,
                                                   const bounding_box& box,
                                                   const gradation_options& options = {});

}  // namespace asterism
