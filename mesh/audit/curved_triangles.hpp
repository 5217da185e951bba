// SPDX-License-Identifier: MIT
//
// Proves that the quadratic maps of second-order triangles turn nothing over: that the determinant
// of the derivative, which is quadratic itself, is positive all over each triangle.
//
// A polynomial in Bernstein's form lies between its least and its greatest coefficient. The six
// coefficients of the determinant are computed in doubles that carry a bound of their error; if
// these do not prove that all are positive, in rationals. Coefficients that are not all positive
// decide nothing. The triangle is then halved, each part up to `most_halvings` times, until the
// coefficients of every part are positive, or a coefficient at a corner of a part is not. A
// coefficient at a corner is the value there: the triangle then certainly folds or collapses at
// that corner. docs/math/curves.md has the formulas.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"

namespace asterism {

// Result of the proof that second-order triangles turn nothing over.
struct second_order_report {
  std::size_t triangles = 0;
  std::size_t curved_sides = 0;  // whose node is not the middle, rounded
  std::size_t on_curves = 0;     // of these: the node is on a curve of the domain, as rounding goes
  std::size_t kept_straight = 0;  // sides on curves that would fold a triangle; set by their maker
  // Lower bound, over all triangles that are proved, of the determinant divided by that of the
  // triangle with straight sides.
  double least_jacobian = 0;
  std::vector<vertex_index> folded;     // triangles with a point at which it is not positive
  std::vector<vertex_index> undecided;  // triangles of which neither is proved

  // True if there is a triangle, and every triangle is proved.
  bool proved() const { return triangles > 0 && folded.empty() && undecided.empty(); }
};

// Judges the triangles of a mesh. `curved` has the nodes of sides that are not straight, ascending
// by the sides' ends; entries whose ends are no side of a triangle are ignored. `shape`, if not
// null, is the domain in which the boundary's segments are numbered: the nodes are compared with
// its curves.
ASTERISM_EXPORT second_order_report prove_second_order(const mesh& subject,
                                                       const std::vector<side_node>& curved,
                                                       const domain* shape);

}  // namespace asterism
