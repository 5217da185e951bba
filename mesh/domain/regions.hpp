// SPDX-License-Identifier: MIT
//
// Finds which faces of a plane graph are the domain, and the numbers of its regions. Works inside
// check_domain.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/domain_repairs.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"
#include "asterism/mesh/domain/polygon_faces.hpp"

namespace asterism::internal {

// Classes of the faces, by face, as face_map names them.
struct domain_parts {
  // Faces that are no part of the domain: the outside, faces that no polygon contains if there are
  // polygons, and faces with hole points.
  std::vector<bool> removed;
  std::vector<int> region;  // of the others
  polygon_faces polygons;   // of a domain with polygons
};

// Classifies the faces. `faces` are those of `graph`, whose edges came from `d`. Fails for a hole
// or region point that is in no face, or contradicts another one, and for a polygon's ring that is
// not closed. Anomalies of polygons are reported in `repairs`.
result<domain_parts> find_parts(const domain& d, const plane_graph& graph, const face_map& faces,
                                domain_repairs& repairs);

}  // namespace asterism::internal
