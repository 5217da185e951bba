// SPDX-License-Identifier: MIT
//
// Fits a triangulation to a metric that turns by much over one edge.
//
// Refinement cannot make stars agree in such a metric, but in a relaxed one it can
// (pipeline/metric_relaxation.hpp). Starting from that mesh, positions and connections are changed
// step by step. The steps end when the metric as given sees good angles, and centres of triangles
// that are farther from the site across each edge: then the stars of these sites in the metric
// given should be these triangles.
//
// It proposes a triangulation and nothing more, in plain doubles: the auditor decides, exactly,
// whether it is the mesh of its stars. Guaranteed is that every triangle turns left and segments
// are covered by subsegments throughout, that given vertices stay where they are, and that the work
// is bounded by counts. Not guaranteed is that any angle or star gets what it should.
// docs/design/fitting.md has the energies, the steps and what was measured.
#pragma once

#include <cstddef>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

struct fitting_options {
  double angle_bound = 20;  // degrees, 0 <= bound < 60
  // Degrees above the bound that are aimed at, default 4.5: neighbours compete.
  double degrees_above_bound = 4.5;
  cancellation stop;  // polled now and then
};

struct fitted_domain {
  // Triangulation proposed, for an audit; its sites have the field's tensors. The domain's vertices
  // come first, then the sites on its segments, then the others. Regions are left out.
  mesh triangulation;
  // Number of its triangles with an angle below the bound, and its smallest angle in degrees.
  // Corners of the domain that are sharper themselves do not count. In doubles.
  std::size_t low = 0;
  double worst_angle = 180;
  std::size_t moves = 0, flips = 0;           // done, with those undone later
  std::size_t collapses = 0, insertions = 0;  // kept
  std::size_t rounds = 0;                     // sweeps over all vertices
  bool stopped = false;                       // by options.stop; what there was is proposed
};

// Fits `start` to the field. `d` must have been accepted by check_domain, and `start` be a
// triangulation of it, as make_mesh makes one where all stars agree; the tensors of its sites are
// not used. Deterministic. Fails where the field does, inside the domain, and where `start` is no
// such triangulation in doubles.
result<fitted_domain> fit(const domain& d, const metric_field& field, const mesh& start,
                          const fitting_options& options);

}  // namespace asterism::internal
