// SPDX-License-Identifier: MIT
//
// Finds which faces of a plane graph the polygons of a domain contain. Works inside check_domain.
//
// From the outside, which no ring encloses, every face is reached across edges; across an edge the
// rings change sides that run along it an odd number of times. No point is tested: the answer is as
// exact as the graph, for faces in which there is no double, too.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {

// A ring: the number of its polygon, and its number within the polygon, from 0.
struct ring_place {
  std::size_t polygon = 0, ring = 0;
};

struct polygon_faces {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // Region numbers of polygons, in ascending order; the first is that of polygons without a
  // number.
  std::vector<std::optional<int>> features;
  // By face, as face_map names them: the first of the features that contain it, or none.
  std::vector<std::size_t> feature_of;
  // Number of faces that several features contain; for the first such face a half-edge around it
  // and two of the features.
  std::size_t shared = 0, shared_half_edge = 0;
  std::pair<std::size_t, std::size_t> shared_features;
  std::vector<ring_place> flat;  // rings that enclose nothing
};

// Finds the faces. `faces` are those of `graph`, whose edges came from `d`. Fails for a ring that
// is not closed. Time: O(n log n) for n segments.
result<polygon_faces> find_polygon_faces(const domain& d, const plane_graph& graph,
                                         const face_map& faces);

}  // namespace asterism::internal
