// SPDX-License-Identifier: MIT
//
// The main job in one call: domain and metric field in, outcome with mesh out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/domain.hpp"
#include "asterism/mesh/mesh.hpp"
#include "asterism/mesh/metric_field.hpp"
#include "asterism/mesh/relaxation_report.hpp"

namespace asterism {

// The thesis's two heuristics, and `guaranteed`: with a size limit the domain is filled first
// (fill/fill.hpp), then defects are mended at the points the arcs offer, and in the end every star
// is held against all sites.
enum class refinement_strategy { voronoi_arcs, poisson_darts, guaranteed };

struct refinement_options {
  double angle_bound = 20;  // degrees, 0 <= bound < 60; measured from all three vertices
  refinement_strategy strategy = refinement_strategy::guaranteed;
  // No site is inserted nearer than this to another one, in metric length, both ways. Darts start
  // from it and shrink it. Empty: chosen from the domain (refine_tolerance.hpp) and reported in the
  // outcome.
  std::optional<double> tolerance;
  // A triangle is too large when its sites are farther than 0.75 metric units from their nearest
  // common Voronoi vertex, a boundary piece when it is longer than 1.2: edges then come out around
  // length 1. Checked only when set (the command line sets it when --size is given).
  bool limit_size = false;
  std::size_t max_sites = 100000;
  // The domain's vertices are the sites of a mesh: if no triangle of their stars is left to mend,
  // no site is added and no piece divided, whatever else could still be improved.
  bool keep_if_complete = false;
  // Asked now and then; a sentence ends refinement, and becomes part of the reason.
  std::function<std::optional<std::string>()> stop;
  int max_rejected = 100;  // darts in a row before the tolerance shrinks
  std::uint64_t seed = 1;  // darts
  // What is complete is improved in so many passes at most (improvement.hpp); each refines anew.
  std::size_t improve_passes = 0;
  // Where the stars cannot agree in the metric as given, it is made to vary more slowly until they
  // do (relaxation.hpp), and the outcome says so; `guaranteed` alone. Without this a run ends with
  // disagreeing triangles there.
  bool relax = true;
};

struct refinement_progress {
  bool filling = false;  // sites are being proposed; nothing is known of triangles yet
  std::size_t sites = 0, disagreeing = 0, low_angle = 0, too_large = 0;
  double sites_expected = 0;  // while filling, about; 0 when that cannot be told yet
};

// Corner of the domain whose angle in its own metric is below the bound: it cannot be met there.
struct exempt_corner {
  index vertex = 0;
  double angle = 0;  // degrees, as its own metric sees it, between its two segments
};

// What the passes asked for have brought.
struct improvement_report {
  std::size_t passes = 0;          // that were accepted
  std::size_t tries = 0;           // refinements done for them
  std::size_t removed = 0;         // sites left out in accepted tries; some may have come again
  std::size_t moved = 0;           // sites moved in them
  std::size_t sites_before = 0;    // before the first pass
  double mean_quality_before = 0;  // mesh_statistics.hpp
  double mean_quality_after = 0;
  bool stopped = false;  // by options.stop; the mesh is what had been accepted
};

// The metric given turns by so much over an edge that refinement did not make stars agree; a mesh
// of the metric softened was fitted to the one given (fitting.hpp), and in that they do. It keeps
// to the density wanted, with triangles of other shapes: outcome.too_large has those whose sites
// are farther from their Voronoi vertex than the size asks for.
struct fitting_report {
  std::string why;             // how refinement ended before, one sentence
  double power = 1;            // the aspects of the metric whose mesh was fitted, to this
  std::size_t low_before = 0;  // triangles of that below the bound in the metric given
  std::size_t rounds = 0, moves = 0, flips = 0, collapses = 0, insertions = 0;
};

struct refinement_outcome {
  bool complete = false;
  bool stopped = false;  // by options.stop
  std::string reason;    // one sentence; why it ended
  mesh result;
  double tolerance = 0;  // the one in force at the end
  std::size_t sites = 0, triangles = 0, disagreeing = 0, low_angle = 0, too_large = 0;
  std::size_t unmade = 0;  // sites whose star was never made, as the run ended before
  bool jumps = false;      // some disagree where the metric jumps, or all but jumps
  bool crowded = false;    // the fill was given up (fill/fill.hpp): the given vertices alone
  std::size_t inserted = 0, splits = 0, candidates_rejected = 0;
  // Where the size wanted would have taken more sites than max_sites allows, edges were made this
  // many times as long, all of them, and about so many sites would have been wanted (0: the run
  // was stopped before that could be told).
  double coarser = 1, sites_wanted = 0;
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
};

// `d` must have been accepted by check_domain. Fails only where the metric field does, or for
// options out of range. `progress` may be empty; it is called now and then from this thread.
result<refinement_outcome> make_mesh(
    const domain& d, const metric_field& field, const refinement_options& options,
    const std::function<void(const refinement_progress&)>& progress = {});

}  // namespace asterism
