// SPDX-License-Identifier: MIT
//
// Refuses a site w beside the neighbours x and y of v, without a Voronoi vertex to start from: the
// directions in which v and w may see a common point are covered by cones, and in each of them one
// reason forbids all of them. For neighbours whose metrics are stretched in directions of their
// own, where star_gap finds no vertex or one whose bounds decide nothing.
//
// Method: in v's frame (kernels/normal_frame.hpp) a ray first meets w's bisector at the parameter
// 1/s_w. At both ends of a cone an upper bound of s_w is compared with a lower bound of s_x, or
// beyond x with the line through w and x. If the upper bound is convex and the lower one concave,
// the ends settle all directions in between. A cone that is not settled is split at the ray of a
// neighbour or in the middle, a few times at most. Proof: docs/math/direction-cover.md. Plain
// doubles with running error bounds, in any floating-point environment.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// True: edge_test(v, w, x, y) and insertion_test(v, w, x, y) are certainly false, whatever the
// ties. False: not known. x and y may be anywhere. Requires four distinct sites with positive
// definite metrics.
bool no_direction_is_left(const site& v, const site& w, const site& x, const site& y);

}  // namespace asterism::internal
