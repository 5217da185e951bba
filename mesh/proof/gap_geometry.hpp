// SPDX-License-Identifier: MIT
//
// Estimates, in doubles, where the bisectors around a gap of a star are: witnesses are searched for
// there. Decides nothing.
#pragma once

#include <cstdint>
#include <optional>

#include "asterism/mesh/proof/gap_row.hpp"

namespace asterism::internal::proof_detail {

using offset = vector2<double>;

// Returns the displacement from v to z.
offset from(const site& v, const site& z);

// Returns the coefficients of p in the basis of x and y.
offset in_basis(const offset& p, const offset& x, const offset& y);

// Returns the point, as offset from v, that is equally far from the three sites in their own
// metrics, to rounding: by Newton's method from the centre of their circle in the sum of the
// metrics.
offset voronoi_vertex(const site& v, const site& x, const site& y);

// Returns `part` as a number of grid steps, rounded up; nothing if it is below `least` or above the
// range of the format.
std::optional<std::int32_t> on_grid(double part, double least);

// Returns 1 / t for the least t at which t u is as near to z as to v; negative if there is none.
double first_meeting(const site& v, const offset& z, const site& at, const offset& u);

// Returns the least t for which the segment from t z to q is nowhere nearer to v than to z: the
// greater of two parameters, at which the ray along z meets the bisector and the bisector's tangent
// at q.
double part_of_edge(const site& v, const offset& z, const site& at, const offset& q);

// Returns the grid point at `part` times (1 + slack) / bound, with coefficients rounded up. With
// `bound` from first_meeting(), `part` / bound is on a bisector, and the point just beyond it.
std::optional<proof_point> point_along(const offset& part, double bound, double slack);

// The sites of a gap, with the displacements from its centre to its neighbours. Directions are
// given as parts of these.
struct gap_ends {
  const site &v, &x, &y;
  offset to_x, to_y;

  gap_ends(const site& centre, const site& first, const site& last)
      : v(centre), x(first), y(last), to_x(from(v, x)), to_y(from(v, y)) {}
  gap_sites sites() const { return {v, x, y}; }
  offset at(const offset& part) const { return part.x * to_x + part.y * to_y; }
  double meets_x(const offset& part) const { return first_meeting(v, to_x, x, at(part)); }
  double meets_y(const offset& part) const { return first_meeting(v, to_y, y, at(part)); }
};

}  // namespace asterism::internal::proof_detail
