// SPDX-License-Identifier: MIT
//
// Accepts most edges of a mesh by one quick test: the point in which the edge itself crosses the
// bisector of its ends is good, unless an angle opposite the edge is about 90 degrees or more.
//
// Method: on the segment from v to w the difference of the distances from v and w changes sign
// once, in the point p that divides it in the ratio of its length in w's metric to that in v's. So
// both see p, and the triangle v, w, p is the segment from v to w. A site that is farther from each
// point of it than v or w does not lie on it. v dominates p over x if x is farther than v from
// every point between v and p: a quadratic along the segment, which is least at its ends unless x's
// metric is much finer. Likewise w, and y. Plain doubles with error bounds, in any floating-point
// environment.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// True: edge_test(v, w, x, y) and insertion_test(v, w, x, y) are certainly true, whatever the ties.
// False: not known. x and y may be anywhere. Requires four distinct sites with positive definite
// metrics.
bool segment_shows_edge(const site& v, const site& w, const site& x, const site& y);

}  // namespace asterism::internal
