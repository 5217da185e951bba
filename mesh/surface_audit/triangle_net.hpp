// SPDX-License-Identifier: MIT
//
// Writes a Bezier piece over a triangle of its parameters in Bernstein form: the piece over the
// triangle lies in the convex hull of the net's points. Everything is enclosed by intervals, which
// require a floating_point_scope(rounding::upward).
#pragma once

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Returns the net of degree degree_u + degree_v over the triangle, by the polar form of the tensor
// product symmetrised (docs/math/surfaces.md): in doubles with a bound of their errors where
// possible (plain_net.hpp), else in intervals.
triangle_net net_over(const tensor_net& from, const parameter_triangle& corners, bool is_rational);
triangle_net net_in_intervals(const tensor_net& from, const parameter_triangle& corners,
                              bool is_rational);

// Returns the single point of the net over a triangle with three equal corners.
weighted_point point_at(const tensor_net& from, const parameter_corner& at, bool is_rational);

}  // namespace asterism::internal
