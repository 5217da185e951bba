// SPDX-License-Identifier: MIT
//
// Bounds how far curves on patches are from each other in space: the two curves of an edge, and a
// curve and the polygon that replaces it. Two curves r(c(t)) are compared place by place, in
// Bernstein's form of their difference (docs/math/surfaces.md, "Trims").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

namespace asterism::internal {

// Refers to a curve on its patch. All must outlive this object.
struct curve_on_patch {
  const std::vector<bezier_piece>& pieces;
  const patch_spans& spans;  // of the patch
  const trim_curve& curve;
};

// Returns an upper bound of the greatest distance of the points of two curves at the same place;
// with `opposite` the second one runs from 1 to 0. Bounds below `negligible` are not narrowed.
// Infinite where nothing is proved.
double trim_gap_above(const curve_on_patch& a, const curve_on_patch& b, bool opposite,
                      double negligible);

// A chord in the plane of the parameters.
struct trim_chord {
  double from = 0, to = 0;  // places of the curve
  std::array<double, 2> start{}, end{};
};
// Returns an upper bound of both one-sided distances of the part of the curve and the image of the
// chord. `units` are lengths of u and v that are about alike; they decide nothing.
double chord_distance_above(const curve_on_patch& c, const trim_chord& chord,
                            const std::array<double, 2>& units, double negligible);

}  // namespace asterism::internal
