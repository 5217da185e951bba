// SPDX-License-Identifier: MIT
//
// Outcome of a meshing run: the mesh, how the run ended, and what it took.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/relaxation_report.hpp"

namespace asterism {

// A corner of the domain whose angle in its own metric is below the bound: it cannot be met there.
struct exempt_corner {
  vertex_index vertex = 0;
  double angle = 0;  // degrees, as its own metric sees it, between its two segments
};

// The effect of the improvement passes that were asked for.
struct improvement_report {
  std::size_t passes = 0;          // that were accepted
  std::size_t tries = 0;           // refinements done for them
  std::size_t removed = 0;         // sites left out in accepted tries; some may have come again
  std::size_t moved = 0;           // sites moved in them
  std::size_t sites_before = 0;    // before the first pass
  double mean_quality_before = 0;  // numerics/mesh_statistics.hpp
  double mean_quality_after = 0;
  bool stopped = false;  // by options.stop; the mesh is what had been accepted
};

// How a mesh of a softened metric was fitted to the metric given (optimize/optimize_mesh.hpp),
// because that turns so much over an edge that refinement did not make stars agree. After fitting
// they do. The mesh has the density wanted and triangles of other shapes: outcome.too_large counts
// those whose sites are farther from their Voronoi vertex than the size asks for.
struct fitting_report {
  std::string why;             // how refinement ended before, one sentence
  double power = 1;            // the aspects of the metric whose mesh was fitted, to this
  std::size_t low_before = 0;  // triangles of that below the bound in the metric given
  std::size_t rounds = 0, moves = 0, flips = 0, collapses = 0, insertions = 0;
};

// How a run ended, with the mesh it made.
struct mesh_outcome {
  bool complete = false;
  bool stopped = false;  // by options.stop
  std::string reason;    // one sentence; why it ended
  mesh result;
  double tolerance = 0;  // the one in force at the end
  std::size_t sites = 0, triangles = 0, disagreeing = 0, low_angle = 0, too_large = 0;
  std::size_t stars_missing = 0;  // sites whose star was never made, as the run ended before
  bool jumps = false;             // some disagree where the metric jumps, or all but jumps
  bool crowded = false;           // the fill was given up (fill/fill.hpp): the given vertices alone
  std::size_t inserted = 0, splits = 0, candidates_rejected = 0;
  // Factor by which every edge was made longer, because the size wanted would have taken more sites
  // than max_sites allows; and about how many sites it would have taken (0: the run was stopped
  // before that could be told).
  double length_factor = 1, sites_wanted = 0;
  // Number of stars that the local search had got wrong and the final check of all sites mended.
  std::size_t star_repairs = 0;
  std::vector<exempt_corner> exempt;
  std::vector<triangle> exempt_triangles;  // of result.triangles, below the bound at or across them
  tier_counters counters;
  std::optional<improvement_report> improved;  // where passes were asked for and it is complete
  // Present if the mesh is of a relaxed metric. `complete` then means that the angle bound is met
  // in the metric given as well.
  std::optional<relaxation_report> relaxed;
  std::optional<fitting_report> fitted;  // then it is not relaxed
};

}  // namespace asterism
