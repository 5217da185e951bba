// SPDX-License-Identifier: MIT
//
// Implements the first stage of the exact tier: the pointwise predicates in integers of a fixed
// width. The coordinates of a question become 62-bit integers in one common unit, and so do its
// metrics; products then have 128, 192 and 320 bits. There is no rounding and no allocation.
//
// Undecided where the numbers of a question differ so much in size, or have so many bits, that no
// common unit holds them all. Neither their magnitude nor the floating-point environment matters.
// Input: as for exact_kernel. Bounds on every width: fixed_width.cpp.
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal::fixed_width {

uncertain_sign orientation(const point& p, const point& q, const point& r);
uncertain_bool is_positive_definite(const metric_tensor& metric);
uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
                         const point& p);
uncertain_sign compare_distance(const site& v, const site& w, const point& q);
uncertain_bool in_wedge(const site& v, const site& w, const point& q);
// Decides domination; undecided where the discriminant is needed, at a bulge of the bisector.
uncertain_sign dominates(const site& v, const site& w, const point& p);

// Decides the insertion test of four sites that all have the metric of v; ties as edge_test does
// (predicates/tie_breaking.hpp), or with a no, as insertion_test does.
uncertain_bool insertion_test_equal_metrics(const site& v, const site& w, const site& x,
                                            const site& y);
uncertain_bool edge_test_equal_metrics(const site& v, const site& w, const site& x, const site& y);

}  // namespace asterism::internal::fixed_width
