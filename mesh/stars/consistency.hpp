// SPDX-License-Identifier: MIT
//
// Checks that the stars agree: compares every triangle of every star with the stars of its other
// vertices.
//
// Source: the thesis, definition 9. Two kinds of defect go beyond it, each named by its vertex. A
// star with a gap of 180 degrees or more leaves a hole. A star that did not settle
// (stars/star_construction.hpp) is not known to be a star at all.
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
  // Vertices {owner, y, x} of the defect, counter-clockwise for a triangle. A wide gap is bounded
  // by y and x, which are equal if the star has one neighbour; if it has none, and for an unsettled
  // star, all three are the owner.
  triangle where{};
};

struct consistency_report {
  // Triangles, each once, smallest index first, in lexicographic order.
  std::vector<triangle> agreeing;     // in the stars of all three vertices
  std::vector<triangle> disagreeing;  // in some, not in all
  // Defects by owner, in the order of its neighbours; empty exactly when the stars make a mesh. A
  // triangle counts for each star that holds it and each star where it is missing.
  std::vector<defect> defects;

  bool consistent() const { return defects.empty(); }
};

// Compares all stars. Exact; takes time linear in the total size of the stars.
consistency_report check_consistency(const site_oracle& oracle, const star_set& stars);

// Returns the agreeing triangles of stars that are known to be consistent, without a comparison.
std::vector<triangle> triangles_of_consistent(const star_set& stars);

}  // namespace asterism::internal
