// SPDX-License-Identifier: MIT
//
// Makes the built-in domains, and adds random points to a domain.
#pragma once

#include <cstddef>
#include <cstdint>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism {

// Returns [-1,1]^2, counter-clockwise from (-1,-1); segments marked 1 (bottom) to 4 (left).
ASTERISM_EXPORT domain square();

// Number of intervals of the airfoil, and its box.
struct airfoil_options {
  std::size_t points_per_side = 40;  // intervals along the upper side and along the lower one
  bounding_box box = {{-1, -1}, {2, 1}};
};

// Makes a NACA 0012 airfoil with chord from (0,0) to (1,0), as a hole in a box. The trailing edge
// is closed and sharp: the last coefficient of the thickness polynomial is -0.1036 instead of
// -0.1015 (Abbott and von Doenhoff, "Theory of Wing Sections", section 6.4, for the polynomial).
// Points are denser towards both edges. Segments of the box are marked 1, those of the airfoil 2.
// Fails for fewer than 2 or more than 1,000,000 intervals, or a box that does not contain
// [0,1] x [-0.06,0.06] strictly.
ASTERISM_EXPORT result<domain> airfoil(const airfoil_options& options = {});

// Adds `count` vertices to `d`: drawn uniformly, from a generator that gives the same points
// everywhere, in the bounding box shrunk to nine tenths about its centre, kept when strictly inside
// the domain and on no earlier vertex; 5000 or more are numbered along a Hilbert curve, fewer as
// they are drawn. `d` must have been accepted by check_domain, which accepts the outcome too. Fails
// when the domain fills so little of its box that 1000 draws a point are not enough.
ASTERISM_EXPORT result<domain> add_random_points(domain d, std::size_t count, std::uint64_t seed);

}  // namespace asterism
