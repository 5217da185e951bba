// SPDX-License-Identifier: MIT
//
// Draws cubics through the boundary vertices of a mesh, on which new vertices between these are
// put. Internal to mesh_outline.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// The cubic has the direction of the circle through three vertices in a row, at a vertex that is no
// corner; beside a corner, a direction with which the two ends are mirror images, as of an arc. Its
// control points are as far from the ends as those of an arc, which the cubic approximates to the
// sixth order.
//
// An edge at one end of which the boundary turns twenty times less than at the other is part of a
// straight side: it stays straight, and the curve that meets it begins in its direction. So a side
// of two edges or more is not bent by the side that it meets at a flat angle.
class outline_curves {
 public:
  // `at` has the edges of the boundary at each vertex; `smooth` is set for vertices at which
  // exactly two edges meet, and which are no corners. The mesh, `at` and `smooth` must outlive this
  // object.
  outline_curves(const mesh& m, const std::vector<std::vector<vertex_index>>& at,
                 const std::vector<char>& smooth)
      : mesh_(m), at_(at), smooth_(smooth) {}

  // Returns the inner control points of the cubic from the first of these vertices of the boundary
  // to the last, which follow each other; nothing where the boundary is straight, or turns by so
  // much that a cubic would not follow it.
  std::optional<std::array<point, 2>> control(const vertex_index* first, std::size_t count) const;

 private:
  const point& where(vertex_index v) const { return mesh_.sites[v].position; }
  vertex_index beyond(vertex_index v, vertex_index from) const;
  double turn_at(vertex_index v, vertex_index from) const;
  bool is_straight(vertex_index a, vertex_index b) const;
  std::optional<point> direction(vertex_index v, vertex_index to) const;

  const mesh& mesh_;
  const std::vector<std::vector<vertex_index>>& at_;
  const std::vector<char>& smooth_;
};

// Removes cubics whose hull meets another curve, segment or vertex: any chord of a cubic is in its
// hull.
void drop_curves_in_the_way(domain& shape);

// Reorders the lists of vertices between the ends of segments to the order and directions of
// another domain's segments. Returns false where a segment is not among these.
bool bring_to_order(const domain& before, const domain& now,
                    std::vector<std::vector<point>>& between);

}  // namespace asterism::internal
