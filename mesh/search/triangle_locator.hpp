// SPDX-License-Identifier: MIT
//
// Finds the triangle that a point is in, and the weights of its corners there, in plain doubles:
// for values that are interpolated. A point outside of all triangles gets one near it.
// transfer/triangle_finder.hpp decides by exact orientations which closed triangle contains a
// point.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Undirected edge of a graph over numbered places.
struct graph_edge {
  vertex_index a = 0, b = 0;
};

// All functions may be called from several threads.
class triangle_locator {
 public:
  // Indexes the triangles of a mesh that are counter-clockwise; requires one at least. Keeps its
  // own copy.
  explicit triangle_locator(const mesh& m);
  // Indexes `m`, a part of a larger mesh, and searches as an index of the whole mesh would; `box`
  // is the box around the sites of the whole mesh.
  triangle_locator(const mesh& m, const bounding_box& box);

  struct located {
    vertex_index triangle = 0;
    std::array<double, 3> weights{};  // of its corners; none is negative, their sum is about 1
    std::size_t looked_at = 0;        // triangles that a search has looked at
    double reach = 0;                 // how far around the point deepest() has searched
  };

  // Returns the triangle in which q's least weight is greatest, the first one of equals. Searches
  // in growing boxes around q until they contain a triangle.
  located deepest(const point& q) const;
  // Walks to q from the triangle `hint`. Returns the result of deepest() if the walk meets the
  // boundary: the triangle depends on the hint only where q is on an edge.
  located nearby(const point& q, vertex_index hint) const;

  const std::vector<point>& places() const { return places_; }
  // Returns the indexed triangles, in their order.
  const std::vector<triangle>& triangles() const { return triangles_; }
  // Returns the edges, each once.
  std::vector<graph_edge> edges() const;

 private:
  std::vector<point> places_;
  std::vector<triangle> triangles_;
  mesh_links links_;
  bounding_box box_;
  box_index boxes_;
};

}  // namespace asterism::internal
