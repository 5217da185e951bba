// SPDX-License-Identifier: MIT
//
// Makes the triangles of a mesh second-order ones that are proved valid: sides on curves follow the
// curve, where that folds no triangle.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/curved_triangles.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"

namespace asterism {

// The sides that are not straight, ascending by their ends, and the proof of the triangles.
struct curved_sides {
  std::vector<side_node> nodes;
  second_order_report report;
};

// Puts a node on the curve of each subsegment of a chord. A triangle that would fold, or for which
// folding is undecided, has straight sides; `report.kept_straight` counts them. `shape` is the
// domain that the boundary's segments are numbered in, accepted by check_domain.
ASTERISM_EXPORT result<curved_sides> curve_sides(const mesh& m, const domain& shape);

// Judges the curved sides that a file gives to its triangles, unchanged. Fails, naming the
// triangle, where one folds or is undecided.
ASTERISM_EXPORT result<curved_sides> given_sides(const mesh& m, std::vector<side_node> nodes);

// Returns a sentence on the number of sides kept straight; empty if there are none.
ASTERISM_EXPORT std::string note_of_straight_sides(const second_order_report& report);

}  // namespace asterism
