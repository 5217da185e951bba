// SPDX-License-Identifier: MIT
//
// Data of a proof that a mesh satisfies its claims: the witnesses with which a checker decides it
// without any search. docs/math/proof-format.md states what an accepted proof implies.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/proof/whole.hpp"

namespace asterism::internal {

// A point beside an edge or in a gap of a star, in steps of 2^-26 of two edges from a vertex.
using proof_point = std::array<std::int32_t, 2>;

// The reason why a gap refuses a site, where the gap's own row does not show it.
struct proof_exception {
  enum class reason : std::uint8_t {
    by_gap = 0,   // a fan of points from the centre of the gap's star
    by_site = 1,  // the same from the site, in whose star the centre would be
    hidden = 2,   // a segment between the two
    row = 3,      // no reason: the row of a gap that has none of three points; the site is `nobody`
    meeting = 4,  // a row that turns where the bisectors of all four sites meet, with weights
  };

  static constexpr vertex_index nobody = 0xffffffff;

  std::uint32_t gap = 0;  // 3 t + i: of the corner i of the triangle t
  vertex_index site = 0;
  reason why = reason::by_gap;
  std::uint8_t turn = 0;  // the point up to which all are behind the first neighbour
  // Points from the ray to the first neighbour to the ray to the last; for a hidden site, one pair
  // of numbers: the segment's ends.
  std::vector<proof_point> points;
  // Weights of the two neighbours and of the site at a meeting: 1, 3 or 6 coefficients for each of
  // the three.
  std::vector<proof_detail::whole> weights = {};
};

// Points that span the region of a gap from x to y, in steps of 2^-26 of the two edges: a point on
// the ray to x, one between, and one on the ray to y.
struct proof_gap {
  std::int32_t on_x = 0;
  proof_point between{0, 0};
  std::int32_t on_y = 0;
};

struct mesh_proof {
  // Corners of a rectangle around the mesh: the lower left and the upper right one.
  point low{0, 0}, high{0, 0};
  // Triangles between the mesh and the rectangle. Its corners are numbered after the vertices,
  // counter-clockwise from the lower left one.
  std::vector<triangle> outside;
  // For each hole point, then each region point of the domain, a triangle that contains it. The
  // triangles of the mesh are numbered first, those outside after them.
  std::vector<std::uint32_t> places;
  // Points of the inner edges that need a witness (is_edge_asked), in the order of these edges.
  // Zeros where a meeting shows that an edge is kept.
  std::vector<proof_point> edges;
  std::vector<proof_gap> gaps;              // of the gaps that are asked about, in their order
  double squared_radius = 0;                // of the balls that the walks keep to
  std::vector<proof_exception> exceptions;  // sorted by site, then gap
};

}  // namespace asterism::internal
