// SPDX-License-Identifier: MIT
//
// Finds the metric in which a mesh was made, as far as its edges show.
#pragma once

#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Returns, at each vertex with the n edges e, the inverse of (2/n) sum e e^T: in a mesh of unit
// edges in a constant metric that metric, where the edges of a vertex are evenly spread. Fails,
// naming the vertex, where all of its edges are along one line. Source: Coupez, "Metric
// construction by length distribution tensor and edge based error for anisotropic adaptive
// meshing", 2011.
ASTERISM_EXPORT result<std::vector<metric_tensor>> implied_metric(const mesh& m);

}  // namespace asterism
