// SPDX-License-Identifier: MIT
//
// Measures the regions of a mesh and of its domain.
//
// Areas are sums of products of coordinates. They are summed exactly and rounded once, to the
// nearest double: two meshes of one region have the same number, however it is divided, unless a
// vertex on its boundary was rounded.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Areas of regions by region number, in square units of the coordinates; infinite where the sum
// exceeds the doubles.
using areas_by_region = std::map<int, double>;

// Returns the areas of the regions of a mesh. Clockwise triangles count as negative; triangles with
// corners that do not exist or are not finite are left out.
ASTERISM_EXPORT areas_by_region areas_of_regions(const mesh& m);
// Returns the areas that the segments of a domain enclose, by region. Leaves out segments whose
// ends do not exist or are not finite. Requires known regions (check_domain).
ASTERISM_EXPORT areas_by_region areas_of_regions(const domain& d);

// Areas of one region: in the mesh, in the domain, and before an adaptation.
struct region_area {
  int number = 0;
  std::optional<double> before = {};  // in the mesh that was adapted, if one was
  std::optional<double> domain = {};  // in the domain, if that is known
  double mesh = 0;
};

// Returns the areas of the regions of a mesh and of its domain, which may be null, by ascending
// numbers. Empty where both have region 1 alone.
ASTERISM_EXPORT std::vector<region_area> measure_regions(const mesh& m, const domain* original);

}  // namespace asterism
