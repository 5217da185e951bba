// SPDX-License-Identifier: MIT
//
// Links triangles of a mesh with their neighbours: across edges, and around vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

inline constexpr vertex_index no_triangle = std::numeric_limits<vertex_index>::max();

// A triangle at a vertex: the triangle's index, and the number of its corner that is the vertex.
struct incidence {
  vertex_index triangle = 0;
  std::uint32_t corner = 0;
};

// Requires a triangulation: indices in range, each directed edge in one triangle at most. Time and
// memory are linear; made by all threads, with the same result for any number of them.
class mesh_links {
 public:
  // Says whether each vertex's neighbours are listed: that takes more than half of the time, and a
  // walk from triangle to triangle does not need it.
  enum class lists { all, no_neighbours };

  mesh_links(std::size_t vertices, const std::vector<triangle>& triangles, lists wanted);
  mesh_links(std::size_t vertices, const std::vector<triangle>& triangles)
      : mesh_links(vertices, triangles, lists::all) {}
  explicit mesh_links(const mesh& m) : mesh_links(m.sites.size(), m.triangles) {}

  // Returns the triangle across from corner i of t, or no_triangle at the boundary.
  vertex_index across(vertex_index t, std::size_t i) const { return across_[t][i]; }
  // Removes and returns what across() returns, for all triangles.
  std::vector<std::array<vertex_index, 3>> take_across() && { return std::move(across_); }
  // Returns the triangles at v, ascending.
  std::span<const incidence> around(vertex_index v) const {
    return {corners_.data() + first_corner_[v], first_corner_[v + 1] - first_corner_[v]};
  }
  // Returns the vertices joined to v by an edge, ascending. Requires their lists.
  std::span<const vertex_index> neighbours(vertex_index v) const {
    return {neighbours_.data() + first_neighbour_[v],
            first_neighbour_[v + 1] - first_neighbour_[v]};
  }
  // True if v has an edge with a triangle on one side alone, or is in no triangle.
  bool on_boundary(vertex_index v) const { return on_boundary_[v] != 0; }
  std::size_t vertices() const { return first_corner_.size() - 1; }
  std::size_t triangles() const { return across_.size(); }

 private:
  void list_corners(const std::vector<triangle>& triangles);
  void list_neighbours(const std::vector<triangle>& triangles);
  void find_across(const std::vector<triangle>& triangles);

  std::vector<std::size_t> first_corner_, first_neighbour_;
  std::vector<incidence> corners_;
  std::vector<vertex_index> neighbours_;
  std::vector<std::array<vertex_index, 3>> across_;
  std::vector<char> on_boundary_;
};

}  // namespace asterism::internal
