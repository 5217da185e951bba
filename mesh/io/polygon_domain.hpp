// SPDX-License-Identifier: MIT
//
// Makes a domain of polygons with holes: finds a point in each hole and, if asked, in each polygon.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

using ring = std::vector<point>;  // its last point is another one than its first

struct polygon {
  std::vector<ring> rings;  // the outer one, then holes
  int region = 1;
};

// Drops points at the end that are where the first one is.
void open_ring(ring& corners);

// Returns the domain, its name left out. Points in holes and regions are proposed in doubles;
// check_domain refuses one that is not where it should be. Fails for a hole or polygon in which no
// point could be found. `regions`: give each polygon the number of its region.
result<domain> domain_of_polygons(const std::vector<polygon>& polygons, bool regions);

}  // namespace asterism::internal
