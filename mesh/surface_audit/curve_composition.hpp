// SPDX-License-Identifier: MIT
//
// Writes curves on a patch as curves in space, in Bernstein's form, and the difference of two.
// Everything is enclosed by intervals, which require a floating_point_scope(rounding::upward).
#pragma once

#include <vector>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

namespace asterism::internal {

// Holds the Bezier points (w u, w v, 0) and w of a curve in the plane, from 0 to 1.
using plane_curve = std::vector<weighted_point>;

// Returns the part of a piece between two places of the curve. Beyond the piece its polynomials are
// continued. Empty if the ends of the piece coincide in doubles.
plane_curve part_of_trim(const trim_piece& piece, const rounded_interval& from,
                         const rounded_interval& to);

// Holds the points of a curve in space times binomials: point k is C(n, k) times the k-th
// coefficient, so that a product of two is a convolution.
using space_curve = std::vector<weighted_point>;

// Returns the curve on the piece, with the origin moved. Beyond the piece its polynomials are
// continued.
space_curve composed(const bezier_piece& piece, const plane_curve& curve,
                     const interval_vector& origin);

// Returns the pieces of a patch that a curve may reach into: each point of the curve lies in one of
// them. Returns none if they are more than four, or if a weight is not certainly positive. Parts
// beyond the patch belong to the pieces at its sides.
std::vector<std::uint32_t> pieces_along(const patch_spans& spans, const plane_curve& curve);

// Returns a bound of the squared distance of two curves at the same parameter; infinite where a
// weight is not certainly positive.
double squared_difference_above(const space_curve& a, const space_curve& b);

}  // namespace asterism::internal
