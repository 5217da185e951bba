// SPDX-License-Identifier: MIT
//
// Makes metrics for a series of solutions, the windows of a run in time, that share one complexity.
//
// The windows are treated as separate parts of one mesh. Second derivatives, the optimum and
// gradation do not cross parts; and the optimum has one constant D and one factor for the sum of
// the complexities: a window with larger second derivatives gets a larger part, which is the
// space-time optimum for windows with equal numbers of time steps. Source: Alauzet, Loseille and
// Olivier, "Time-accurate multi-scale anisotropic mesh adaptation for unsteady flows in CFD", J.
// Comput. Phys. 373, 2018.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/claims/metric_request.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Metric of each window at the vertices of its mesh, and the report of all together.
struct metric_series {
  std::vector<mesh> windows;
  std::vector<std::vector<vertex_index>> left_out;  // vertices of each file without a triangle
  std::vector<double> complexities;                 // of each
  solution_metric_report report;                    // asked and delivered: the sums
};

// Makes the metrics. A window is a file of numbers at the vertices of request.mesh, or a mesh that
// has its own fields; all have fields of the same names. The number of vertices and the complexity
// wanted are means over the windows. Of the request's files only the mesh is read.
result<metric_series> answer_series(const metric_request& request,
                                    const std::vector<std::string>& windows);

}  // namespace asterism::internal
