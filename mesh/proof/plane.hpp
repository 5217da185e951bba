// SPDX-License-Identifier: MIT
//
// A mesh and the triangles around it as one triangulation of a rectangle, through which the stars
// of the mesh are traversed.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal::proof_detail {

// All triangles of the rectangle: first those of the mesh. The edge i of the triangle t, from its
// corner i to the next, has the number 3 t + i, and so has the gap of the star of its corner i.
struct plane {
  static constexpr std::uint32_t none = 0xffffffff;

  const mesh& subject;
  std::array<point, 4> corners;
  std::vector<triangle> triangles;
  std::vector<std::uint32_t> across;    // by edge: the number of its reverse, or none
  std::vector<char> is_segment;         // by edge
  std::vector<std::uint32_t> at_start;  // the triangles at v: at[at_start[v] .. at_start[v + 1])
  std::vector<std::uint32_t> at;

  std::size_t inner_count() const { return subject.triangles.size(); }
  const point& position(vertex_index v) const {
    return v < subject.sites.size() ? subject.sites[v].position : corners[v - subject.sites.size()];
  }
  vertex_index corner(std::uint32_t edge, std::uint32_t steps = 0) const {
    return triangles[edge / 3][(edge % 3 + steps) % 3];
  }
  static std::uint32_t next(std::uint32_t edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
  static std::uint32_t previous(std::uint32_t edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }
};

// Joins the triangles. Indices must be in range. An edge that two triangles have in the same
// direction is joined to none.
plane make_plane(const mesh& subject, const std::array<point, 4>& corners,
                 const std::vector<triangle>& outside);

}  // namespace asterism::internal::proof_detail
