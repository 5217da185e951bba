// SPDX-License-Identifier: MIT
//
// Holds the nodes of the sides of second-order triangles.
//
// Such a triangle is the image of a straight one under a quadratic map: each corner and, for each
// side, a node that the middle of the side goes to. Sides that are not named are straight: their
// node is the middle of their ends, rounded.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// A side that is not straight, by its ends, and its node.
struct side_node {
  vertex_index a = 0, b = 0;  // ends of the side, a < b
  point at;
};

// Returns the node of a straight side: each coordinate rounded once, the same in both directions.
inline point middle_of_side(const point& p, const point& q) {
  return {0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y};
}

}  // namespace asterism
