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

// Areas by the number of the region, in square units of the coordinates; infinite where no double
// is as large.
using areas_by_region = std::map<int, double>;

// Returns the sums of the triangles' areas; those turned the wrong way count against it, and those
// with corners that do not exist or are not finite do not count.
ASTERISM_EXPORT areas_by_region areas_of_regions(const mesh& m);
// Returns what the segments enclose, those left out whose ends do not exist or are not finite.
// Their regions must be known (check_domain).
ASTERISM_EXPORT areas_by_region areas_of_regions(const domain& d);

// One region of a mesh.
struct region_area {
  int number = 0;
  std::optional<double> before = {};  // in the mesh that was adapted, if one was
  std::optional<double> domain = {};  // in the domain, if that is known
  double mesh = 0;
};

// Returns the regions of a mesh and its domain, which may be null, by ascending numbers. Empty
// where both have nothing but region 1: then it is all that there is.
ASTERISM_EXPORT std::vector<region_area> measure_regions(const mesh& m, const domain* original);

}  // namespace asterism
