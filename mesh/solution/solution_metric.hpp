// SPDX-License-Identifier: MIT
//
// Makes the metric, at the vertices of a mesh, in which the next mesh for a solution is best.
//
// The result depends on the order of the steps, which is:
//   1. the Hessian of each field is recovered (mesh/solution/hessian.hpp);
//   2. each is made the L^p-optimal metric of complexity 1, no size of it more than twenty
//      times that of a uniform mesh (mesh/solution/optimal_metric.hpp); of a field
//      that was computed the weaker eigenvalue is raised where no aspect is named
//      (mesh/solution/computed_field.hpp);
//   3. the fields, sorted by name, are intersected one after another by simultaneous reduction;
//   4. that is multiplied by a factor;
//   5. further given metrics are intersected with it, in their order;
//   6. with a step limit it is kept near the metric that the mesh implies;
//   7. sizes are clipped to hmin and hmax, and the weaker eigenvalue is raised to keep the aspect;
//   8. gradation.
// The factor of step 4 is found such that the outcome of steps 4 to 8 has the complexity wanted.
// With a relative error E, step 2 makes M = 0.94 |H| / (E s) instead, as adaptmesh does with err
// (mesh/solution/relative_error.hpp), and the factor is 1.
#pragma once

#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/solution/glued_mesh.hpp"
#include "asterism/mesh/solution/hessian.hpp"
#include "asterism/mesh/solution/solution_metric_options.hpp"
#include "asterism/mesh/solution/solution_metric_report.hpp"

namespace asterism {

// Makes the metric. `intersected` are tensors at the same vertices. Requires a triangulation. Fails
// for options out of range, fields whose number of values is not the number of vertices, and
// derivatives that overflow. Time and memory are linear; parallel, the same for any number of
// threads.
ASTERISM_EXPORT result<solution_metric> make_solution_metric(
    const mesh& m, const std::vector<nodal_values>& fields, const solution_metric_options& options,
    const std::vector<std::vector<metric_tensor>>& intersected = {});

// Makes the metric from second derivatives that are recovered on the continued mesh. Periodic
// partners have the same ones, bit for bit; gradation and the step limit, which ignore the copies,
// may give them different tensors.
ASTERISM_EXPORT result<solution_metric> make_glued_metric(
    const mesh& m, const glued_mesh& glued, const std::vector<nodal_values>& fields,
    const solution_metric_options& options,
    const std::vector<std::vector<metric_tensor>>& intersected = {});

// Makes the metric from given second derivatives, in place of step 1: of a solution of higher
// order, say, or weighted by an adjoint. Fails with options.relative, which needs values.
ASTERISM_EXPORT result<solution_metric> make_hessian_metric(
    const mesh& m, const std::vector<nodal_hessian>& fields, const solution_metric_options& options,
    const std::vector<std::vector<metric_tensor>>& intersected = {});

// Applies bounds and gradation to a given metric, and scales it if a target is asked for;
// the metric takes the place of steps 1 to 3, made isotropic by its greater eigenvalue
// with options.isotropic, and unchanged if no option changes it. Fails with
// options.error.
ASTERISM_EXPORT result<solution_metric> shape_metric(
    const mesh& m, const std::vector<metric_tensor>& given, const solution_metric_options& options,
    const std::vector<std::vector<metric_tensor>>& intersected = {});

}  // namespace asterism
