// SPDX-License-Identifier: MIT
//
// Do the stars agree? Every triangle of every star, held against the stars of its other vertices.
//
// Source: the thesis, definition 9. Beyond it: a star with a gap of 180 degrees or more leaves a
// hole, and one that did not settle (stars/star_construction.hpp) is not known to be a star at all;
// both are defects named by their vertex.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_set.hpp"

namespace asterism::internal {

enum class defect_kind {
  missing_edge,      // edge owner - other is in the owner's star, not in other's
  missing_triangle,  // the edge is in both, the triangle not in other's star
  wide_gap,          // owner's star holds no triangle between its neighbours y and x
  unsettled          // the owner's star met the bound of its construction
};

struct defect {
  defect_kind kind = defect_kind::missing_edge;
  vertex_index owner = 0;  // in whose star the triangle, or gap, is
  vertex_index other = 0;  // in whose star it is missing; the owner for wide_gap and unsettled
  // {owner, y, x}, counter-clockwise for a triangle. For a wide gap y and x bound it
  // (y == x with one neighbour, all three the owner with none); for unsettled the owner alone.
  triangle where{};
};

struct consistency_report {
  // Each once, smallest index first, in lexicographic order.
  std::vector<triangle> agreeing;     // in the stars of all three vertices
  std::vector<triangle> disagreeing;  // in some, not in all
  // By owner, in the order of its neighbours; a triangle counts for each star that holds it and
  // each star where it is missing. Empty exactly when the stars make a mesh.
  std::vector<defect> defects;

  bool consistent() const { return defects.empty(); }
};

// Exact. Linear in the total size of the stars.
consistency_report check_consistency(const site_oracle& oracle, const star_set& stars);

// The same triangle, smallest index first, orientation kept.
triangle canonical(const triangle& t);

}  // namespace asterism::internal
