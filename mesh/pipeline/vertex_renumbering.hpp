// SPDX-License-Identifier: MIT
//
// Numbers the isolated vertices of a domain along a curve while it is meshed, and as they were
// given in the mesh that comes out. Many vertices in the order of a file are met all over memory:
// 100,000 at random took a fifth longer.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Holds the domain as it is meshed. Vertices of segments keep their numbers, and so do all where
// few are isolated or they are along a curve already. Both orders make the same kind of mesh, but
// not the same mesh: what the mesher does first among equals depends on the numbers.
class vertex_renumbering {
 public:
  // The domain must outlive it.
  explicit vertex_renumbering(const domain& d);
  vertex_renumbering(const vertex_renumbering&) = delete;
  vertex_renumbering& operator=(const vertex_renumbering&) = delete;

  const domain& shape() const { return isolated_.empty() ? given_ : along_curve_; }
  // Numbers an outcome made of shape() as the vertices were given.
  void restore(mesh_outcome& outcome) const;

 private:
  void renumber(const bounding_box& box);

  const domain& given_;
  std::vector<vertex_index> isolated_;  // ascending; none where all keep their numbers
  std::vector<vertex_index> sorted_;    // the same along the curve
  domain along_curve_;
};

}  // namespace asterism::internal
