// SPDX-License-Identifier: MIT
//
// Renumbers the isolated vertices of a domain along a curve while it is meshed, and restores their
// numbers in the resulting mesh. In the order of a file, vertices that are near each other may be
// far apart in memory: 100,000 in random order took a fifth longer.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Holds the domain as it is meshed. Renumbers isolated vertices only, and none if they are few or
// follow a curve already. The two orders lead to different meshes of the same quality: the mesher
// breaks ties by the numbers.
class vertex_renumbering {
 public:
  // The domain must outlive the renumbering.
  explicit vertex_renumbering(const domain& d);
  vertex_renumbering(const vertex_renumbering&) = delete;
  vertex_renumbering& operator=(const vertex_renumbering&) = delete;

  const domain& shape() const { return isolated_.empty() ? given_ : along_curve_; }
  // Gives the vertices of an outcome made of shape() their original numbers.
  void restore(mesh_outcome& outcome) const;

 private:
  void renumber(const bounding_box& box);

  const domain& given_;
  std::vector<vertex_index> isolated_;  // ascending; none where all keep their numbers
  std::vector<vertex_index> sorted_;    // the same along the curve
  domain along_curve_;
};

}  // namespace asterism::internal
