// SPDX-License-Identifier: MIT
//
// Fitting a triangulation to a metric that turns by much over one edge.
//
// There refinement cannot make stars agree, but in a metric relaxed they do
// (pipeline/metric_relaxation.hpp). Starting from the mesh of that, positions and connections are
// changed step by step until the metric as given sees good angles, and centres of triangles that
// are farther from the site across each edge: then the stars of these sites in the metric given
// should be these triangles.
//
// It proposes a triangulation and nothing more, in plain doubles: the auditor decides, exactly,
// whether it is the mesh of its stars. What holds: every triangle turns left and
// segments are covered by subsegments throughout, given vertices stay where they are, and the work
// is bounded by counts. What does not: that any angle or star gets what it should.
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
  // By how many degrees more than that is aimed at: neighbours compete.
  double degrees_above_bound = 4.5;
  cancellation stop;  // polled now and then
};

struct fitted_domain {
  // Sites with the field's tensors, the domain's vertices first, then those on its segments, then
  // the others; for an audit. Regions are left out.
  mesh triangulation;
  // Of its triangles those that have an angle below the bound, away from
  // corners of the domain that are sharper themselves, and the smallest angle there; in doubles.
  std::size_t low = 0;
  double worst_angle = 180;
  std::size_t moves = 0, flips = 0;           // done, with those undone later
  std::size_t collapses = 0, insertions = 0;  // kept
  std::size_t rounds = 0;                     // sweeps over all vertices
  bool stopped = false;                       // by options.stop; what there was is proposed
};

// `d` must have been accepted by check_domain, and `start` be a triangulation of it, as make_mesh
// makes one where all stars agree; the tensors of its sites are not used. Deterministic. Fails
// where the field does, inside the domain, and where `start` is no such triangulation in doubles.
result<fitted_domain> fit(const domain& d, const metric_field& field, const mesh& start,
                          const fitting_options& options);

}  // namespace asterism::internal
