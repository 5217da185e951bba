// SPDX-License-Identifier: MIT
//
// Finds the triangle that a point is in, and the weights of its corners there, in plain doubles:
// for values that are interpolated. A point outside of all triangles gets one near it.
// transfer/triangle_finder.hpp decides by exact orientations which closed triangle contains a
// point.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <optional>
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
  using corner_links = std::vector<std::array<vertex_index, 3>>;

  // Indexes the triangles of a mesh that are counter-clockwise; requires one at least. Keeps its
  // own copy.
  explicit triangle_locator(const mesh& m);
  // Indexes `m`, a part of a larger mesh, and searches as an index of the whole mesh would; `box`
  // is the box around the sites of the whole mesh.
  triangle_locator(const mesh& m, const bounding_box& box);
  // Indexes counter-clockwise triangles; `across` has, for each corner, the triangle across from
  // it, or no_triangle.
  triangle_locator(std::vector<point> places, std::vector<triangle> triangles, corner_links across);

  struct located {
    vertex_index triangle = 0;
    std::array<double, 3> weights{};  // of its corners; none is negative, their sum is about 1
    std::size_t looked_at = 0;        // triangles that a search has looked at
    double reach = 0;                 // how far around the point deepest() has searched
  };

  // Returns the triangle in which q's least weight is greatest, the first one of equals. Searches
  // in growing boxes around q until they contain a triangle.
  located deepest(const point& q) const;
  // Returns the result of deepest() in a triangulation, at a place any triangle there. Walks from a
  // triangle that was found near q before, and searches boxes only if the walk meets the boundary.
  located find(const point& q) const;
  // Lets the next find() near q begin at this triangle.
  void begin_near(const point& q, vertex_index t) const {
    if (t < triangles_.size()) last_found_[bin_of(q)].store(t, std::memory_order_relaxed);
  }
  // Walks to q from the triangle `hint`; from the bin of q if there is no such triangle. Returns
  // the result of deepest() if the walk meets the boundary: the triangle depends on the hint only
  // where q is on an edge.
  located nearby(const point& q, vertex_index hint) const;

  const std::vector<point>& places() const { return places_; }
  // Returns the indexed triangles, in their order.
  const std::vector<triangle>& triangles() const { return triangles_; }
  // Returns the edges, each once.
  std::vector<graph_edge> edges() const;

 private:
  // Moves `at` from triangle to triangle to the one that q is in, and sets its weights there.
  // Returns false if the walk meets the boundary.
  bool walk(const point& q, located& at) const;
  bool is_corner(const point& q, vertex_index t) const;
  bool is_in_one(const located& at) const;
  located deepest_by_walk(const point& q) const;
  std::optional<located> deepest_beside(const point& q, const located& from) const;
  void make_bins();
  std::size_t bin_of(const point& q) const;
  bounding_box box_around(vertex_index t) const;
  const box_index& boxes() const;

  std::vector<point> places_;
  std::vector<triangle> triangles_;
  // Number of steps after which a walk is given up.
  std::size_t most_steps_ = 64 + 4 * static_cast<std::size_t>(std::sqrt(triangles_.size()));
  corner_links across_;
  bounding_box box_;
  // Boxes of the triangles, indexed when they are first needed: most walks arrive.
  mutable std::once_flag are_indexed_;
  mutable box_index boxes_;
  std::size_t bins_in_row_ = 1;
  // Hold for each bin, row after row, a triangle with its first corner there, and the triangle that
  // a search in it found last.
  std::vector<vertex_index> first_in_bin_;
  mutable std::vector<std::atomic<vertex_index>> last_found_;
};

}  // namespace asterism::internal
