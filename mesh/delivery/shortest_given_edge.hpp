// SPDX-License-Identifier: MIT
//
// Finds the finest detail of a domain, which may be why a run did not end well.
#pragma once

#include <optional>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Edge between two given vertices, and its length in the plane.
struct given_edge {
  vertex_index a = 0, b = 0;
  point at;                  // the place of a
  double length = 0;         // in the plane
  double part_of_width = 0;  // over the longer side of the box around all sites
};

// Returns the shortest edge of the triangles and the boundary that joins two given vertices; none
// if there is none. In one isotropic metric the two vertices nearest to each other have such an
// edge, if the stars agree.
std::optional<given_edge> shortest_given_edge(const mesh& m);

// True if the edge is so short relative to the domain's width that triangles which meet an angle
// bound do not fit beside it: below 2^-40 doubles have too few places for their corners. A repair
// joins vertices within the same distance at least.
constexpr bool is_rounding(const given_edge& e) { return e.part_of_width < 0x1p-40; }

// Returns two given vertices that are a rounding apart, if the run did not end well and there are
// such; otherwise none.
std::optional<close_vertices> too_close_in(const mesh_outcome& outcome);

}  // namespace asterism::internal
