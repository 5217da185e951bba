// SPDX-License-Identifier: MIT
//
// A second, independent route to the answer of every predicate, for tests alone: names and answers
// are those of kernels/exact_kernel.hpp, the method is the definition taken literally, with CGAL's
// algebraic kernel for roots. It shares no code with predicates/ or kernels/ and takes milliseconds
// a question.
//
// Requires what the kernels require: finite input, positive definite metrics, distinct sites.
#pragma once

#include <optional>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::oracle {

sign orientation(const point& p, const point& q, const point& r);
bool is_positive_definite(const metric_tensor& metric);
// Decides by the determinant of the four lifted points, with |u|^2 = u^T m u.
sign in_circle(const metric_tensor& m, const point& a, const point& b, const point& c,
               const point& p);
sign compare_distance(const site& v, const site& w, const point& q);
bool in_wedge(const site& v, const site& w, const point& q);

// Decides by counting the points of the closed segments vp and wp on Vor{v,w} (thesis, definition
// 6).
sign dominates(const site& v, const site& w, const point& p);

// Decides by solving the two bisector equations as polynomials in the plane.
int voronoi_vertex_count(const site& u, const site& v, const site& w);
int arc_intersection_count(const site& v, const site& w, const site& x);

// Decides by the roots of f_w - f_a and f_w - f_b on the segment.
bool encroaches(const site& a, const site& b, const site& w);

// Decides by a sweep of the plane in a rational direction. Between critical abscissas each branch
// of the conic Vor{v,w} is one section. One point of each is tested by the definition.
bool insertion_test(const site& v, const site& w, const site& x, const site& y);

// Decides as insertion_test does. If that says no, and some point may be equally far from all four
// sites, asks it of f_i + e_i, with explicit small rationals e_i in the order of the tie rule.
// Empty where the rule, which is of first order in e, and the perturbation need not agree: such
// points may form a line, or a segment from a site or another bisector may touch there. Empty also
// where the numbers have so many digits that the e_i may not be small enough.
std::optional<bool> edge_test(const site& v, const site& w, const site& x, const site& y);

}  // namespace asterism::oracle
