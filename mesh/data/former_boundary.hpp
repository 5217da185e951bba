// SPDX-License-Identifier: MIT
//
// Holds the boundary that a mesh had before it was adapted, if another mesh's domain was made of
// it: the new boundary is compared with it.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {

// The former boundary, with internal segments, along the segments of a domain. Each segment leads
// from one former vertex to another. The chords of a curve do so together: the first chord's list
// has the former vertices along all of them.
struct former_boundary {
  // The former vertices between the ends of each segment, from its first to its second: one list
  // for each segment of the domain.
  std::vector<std::vector<point>> between;
  // Greatest distance allowed between the new boundary and the former one, in units of the domain;
  // default: any.
  std::optional<double> allowed = {};
};

// Distance between the boundary of a mesh and the former one.
struct former_boundary_report {
  std::size_t vertices_gone = 0;  // former ones that are no vertices of the domain
  // Upper bound of the distance from any point of either boundary to the other; infinity where the
  // mesh does not follow the segments of the domain.
  double largest_distance = 0;
};

}  // namespace asterism
