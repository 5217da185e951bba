// SPDX-License-Identifier: MIT
//
// Finds the triangle of a mesh that contains a point, by exact orientations.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Refers to the mesh and its links, which must be a triangulation's. All const functions may
// be called from several threads.
class triangle_finder {
 public:
  triangle_finder(const mesh& in, const mesh_links& links) : in_(in), links_(links) {}

  std::array<point, 3> corners(vertex_index t) const {
    const triangle& c = in_.triangles[t];
    return {in_.sites[c[0]].position, in_.sites[c[1]].position, in_.sites[c[2]].position};
  }
  // Returns a corner of t whose opposite edge has q on its far side, tested from `first` on; 3 if q
  // is in the closed triangle.
  std::size_t exit_from(vertex_index t, const point& q, std::size_t first) const;
  // Walks from t to q. Returns no_triangle where that meets the boundary.
  vertex_index walk(const point& q, vertex_index t) const;
  // Builds the index for first_with.
  void make_boxes();
  // Returns the first triangle that contains q and for which `accepts` is true, or no_triangle.
  template <class Accepts>
  vertex_index first_with(const point& q, const Accepts& accepts) const {
    vertex_index least = no_triangle;
    boxes_->visit({q, q}, [&](std::uint32_t t) {
      if (t < least && exit_from(t, q, 0) == 3 && accepts(t)) least = t;
      return true;
    });
    return least;
  }
  // Returns for each point a triangle that contains it, or no_triangle: by a walk from one to the
  // next along the space-filling curve through the box, or by first_with() where a walk meets the
  // boundary. Parallel, the same for any number of threads.
  std::vector<vertex_index> find_all(const std::vector<point>& points, const bounding_box& box);
  const filtered_kernel& kernel() const { return kernel_; }

 private:
  const mesh& in_;
  const mesh_links& links_;
  filtered_kernel kernel_;
  std::optional<box_index> boxes_;  // of the triangles
};

// Returns the triangles of triangle_finder::find_all in the box of the mesh, which must be a
// triangulation.
ASTERISM_EXPORT std::vector<vertex_index> locate_points(const mesh& m,
                                                        const std::vector<point>& points);

}  // namespace asterism::internal
