// SPDX-License-Identifier: MIT
//
// Outcome of a meshing run: the mesh, how the run ended, and what it took.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/relaxation_report.hpp"

namespace asterism {

struct audit_report;  // audit/audit.hpp

// Corner of the domain whose angle in its own metric is below the bound: it cannot be met there.
struct exempt_corner {
  vertex_index vertex = 0;
  double angle = 0;  // degrees, as its own metric sees it, between its two segments
};

// What the passes asked for have brought.
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

// The metric given turns by so much over an edge that refinement did not make stars agree; a mesh
// of the metric softened was fitted to the one given (optimize/optimize_mesh.hpp), and in that they
// do. It keeps to the density wanted, with triangles of other shapes: outcome.too_large has those
// whose sites are farther from their Voronoi vertex than the size asks for.
struct fitting_report {
  std::string why;             // how refinement ended before, one sentence
  double power = 1;            // the aspects of the metric whose mesh was fitted, to this
  std::size_t low_before = 0;  // triangles of that below the bound in the metric given
  std::size_t rounds = 0, moves = 0, flips = 0, collapses = 0, insertions = 0;
};

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
  // Where the size wanted would have taken more sites than max_sites allows, edges were made this
  // many times as long, all of them, and about so many sites would have been wanted (0: the run
  // was stopped before that could be told).
  double length_factor = 1, sites_wanted = 0;
  // Stars a search of what is near had got wrong, found by looking at all sites, and mended.
  std::size_t star_repairs = 0;
  std::vector<exempt_corner> exempt;
  std::vector<triangle> exempt_triangles;  // of result.triangles, below the bound at or across them
  tier_counters counters;
  std::optional<improvement_report> improved;  // where passes were asked for and it is complete
  // Complete, if the mesh is of a relaxed metric, means that the angle bound is met in the metric
  // given as well.
  std::optional<relaxation_report> relaxed;
  std::optional<fitting_report> fitted;  // then it is not relaxed
  // Where the mesh was made by local changes, in the metric that is delivered.
  std::optional<delivered_report> delivered;
  // The auditor's report, where the mesher asked for it already: with the angle bound and the
  // domain of the run, no corner exempt, and nothing asked of the Voronoi diagram.
  std::shared_ptr<const audit_report> audited;
};

}  // namespace asterism
