// SPDX-License-Identifier: MIT
//
// Triangulates all sites of a mesh in one metric, with its subsegments.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/stars/delaunay_triangulation.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// A Delaunay triangulation with the numbers of the sites in the order of their insertion, and back.
struct site_triangulation {
  delaunay_triangulation delaunay;
  std::vector<vertex_index> original;  // by number in the triangulation
  std::vector<vertex_index> numbers;   // in the triangulation, by original number
};

// Returns the constrained Delaunay triangulation of the oracle's sites as this metric measures
// them; none where it takes too many steps, a segment goes through a site, or it is cancelled. The
// oracle's kernel makes and counts the decisions, and must outlive the triangulation.
std::optional<site_triangulation> triangulate(const site_oracle& oracle,
                                              const metric_tensor& metric,
                                              const star_predicates& kernel,
                                              const cancellation& cancelled);

// Marks the faces in the domain, one flag a face: those left of a subsegment, and all that are
// joined to them across edges that are not fixed. Empty where a subsegment is no edge.
std::vector<char> faces_inside(site_triangulation& from, const boundary& edges);

}  // namespace asterism::internal
