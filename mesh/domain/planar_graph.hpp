// SPDX-License-Identifier: MIT
//
// Turns the segments of a domain, which may overlap, repeat and touch, into a plane graph whose
// edges meet only at vertices. Works inside check_domain.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/domain_repairs.hpp"

namespace asterism::internal {

// An edge with its ends as on the first segment that covers it: `source`, an index into the
// domain's segments.
struct covered_edge {
  vertex_index a = 0, b = 0;
  std::size_t source = 0;
  int marker = 0;           // the first of the covering segments' that is not 0
  std::size_t covered = 1;  // by how many segments
};

// A part of a segment, by the edge that it became.
struct covering {
  std::size_t edge = 0, source = 0;
};

struct plane_graph {
  // For each vertex of the domain, the first vertex with the same coordinates. Only these occur in
  // edges.
  std::vector<vertex_index> first_alike;
  std::vector<covered_edge> edges;
  // Parts of all segments in their order, along each segment.
  std::vector<covering> coverings;
};

// Builds the graph. Requires finite coordinates and indices in range. Adds counts to `repairs`, and
// messages unless the domain has polygons: their rings usually meet each other. Fails where two
// segments cross in a point inside both.
result<plane_graph> build_plane_graph(const domain& d, domain_repairs& repairs);

}  // namespace asterism::internal
