// SPDX-License-Identifier: MIT
//
// Holds the outcome of a meshing run: the mesh, how the run ended, and what it took.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/options.hpp"

namespace asterism {

struct past_audit;  // audit/past_audit.hpp

// Corner of the domain whose angle in its own metric is below the bound: it cannot be met there.
struct exempt_corner {
  vertex_index vertex = 0;
  double angle = 0;  // degrees, as its own metric sees it, between its two segments
};

// Ways in which a run ends. pipeline/outcome_text.hpp has a sentence for each.
enum class ending {
  complete,    // all stars agree, and every triangle meets the demands
  site_limit,  // mesh_options::max_sites was reached with demands left
  collateral,  // nothing is left but low angles beside sharp corners, which could not be mended
  stuck,       // bad triangles are left, and no site can be inserted for any of them
  too_steep,   // given up: at some triangles the metric varies faster than sites can resolve
  overworked,  // given up: the most work that is done for so many sites was done
  stopped,     // by mesh_options::stop
  crowded,     // the metric varies too fast, or is too thin, for sites to be spread: the given
               // vertices alone
  one_metric,  // for a whole run: the mesh is of one metric for all sites, the fallback
  intolerable  // for a whole run: stars agree in a metric farther away than is allowed
};

// Place at which the metric varies faster than sites so near to each other can resolve.
struct steep_place {
  std::size_t triangles = 0;  // bad ones that were given up because of such places
  point at;                   // a corner of the first of them
  double spacing = 0;         // metric length: the shortest distance of sites that was considered
};

// A sharp corner of the domain with bad triangles beside it.
struct sharp_corner {
  vertex_index vertex = 0;
  point at;
  double angle = 0;  // degrees, in the vertex's own metric
};

// Site whose star has so many neighbours that the fill was given up (fill/fill.hpp).
struct crowded_site {
  point where;
  std::size_t neighbours = 0;   // in its star
  std::size_t sites = 0;        // proposed when the fill was given up
  bool has_one_metric = false;  // all of them have the same
};

// How one refinement ended, with the numbers that explain it.
struct refinement_ending {
  ending how = ending::complete;  // none of those for a whole run
  refinement_strategy strategy = refinement_strategy::fill;
  std::size_t max_sites = 0;      // the limit in force
  std::size_t sites = 0;          // sites in the end
  std::size_t bad_triangles = 0;  // bad triangles left, those too large or collateral among them
  std::size_t stars_missing = 0;  // sites whose star was never made, as the run ended before
  double tolerance = 0;           // metric length: the one in force at the end
  std::size_t sites_since = 0;    // too_steep: inserted since the first triangle was given up
  std::optional<steep_place> steep;
  // Set for collateral, stuck, too_steep and overworked: the sharpest corner beside bad triangles.
  std::optional<sharp_corner> sharpest;
  std::optional<crowded_site> crowded;  // crowded: the most crowded site
  std::string stopped_because;          // stopped: what mesh_options::stop said
  bool nothing_added = false;  // the given vertices were complete by themselves, and are the mesh
  // Factor by which all edges were made longer because the size wanted would have taken more sites
  // than max_sites allows, default 1; and the estimated number of sites wanted (0: the run was
  // stopped before the estimate).
  double length_factor = 1, sites_wanted = 0;
};

// Result of the passes that mesh_options::improve_passes asks for.
struct improvement_report {
  std::size_t passes = 0;          // passes that were accepted
  std::size_t tries = 0;           // refinements done for them
  std::size_t removed = 0;         // sites left out in accepted tries; some may have come again
  std::size_t moved = 0;           // sites moved in them
  std::size_t sites_before = 0;    // before the first pass
  double mean_quality_before = 0;  // numerics/mesh_statistics.hpp
  double mean_quality_after = 0;
  bool stopped = false;  // by options.stop; the mesh is the last one that was accepted
};

// Distance of a metric in which stars agree, but which is farther from the one wanted than
// mesh_options::metric_tolerance allows.
struct intolerable_distance {
  // Names the distance that is too large: with a tolerance the greatest of all sites; without one
  // the median or, where the median is small enough, the ratio of complexities (density_ratio).
  enum class measure { greatest, median, density };

  double allowed = 0, found = 0;
  measure of = measure::greatest;
  double greatest = 0;  // the tolerance that would be kept
};

// Attempts at a mesh, in the order in which they are made (docs/design/attempts.md).
enum class mesh_attempt : unsigned char {
  delivered_first,    // in a metric delivered, before the one wanted
  requested_briefly,  // in the metric wanted, with little work
  requested,          // in it, with half of the work or all
  delivered,          // in a metric delivered, after the one wanted
  requested_again,    // in the metric wanted, with what two ways may take
  one_metric          // in one metric for all sites
};

// An attempt that was made.
struct attempt_report {
  mesh_attempt what = mesh_attempt::requested;
  std::optional<ending> how;  // none: it led to no mesh
};

// Two given vertices and their distance.
struct close_vertices {
  vertex_index a = 0, b = 0;
  point at;           // the place of a
  double length = 0;  // between them, in the plane
};

// The fallback: one metric for all sites
// (delivery/constant_metric_fallback.hpp).
struct constant_metric_report {
  refinement_ending as_given;  // how refinement ended in the metric as given
  // Two given vertices that are a rounding apart, which leaves no room for triangles beside them.
  std::optional<close_vertices> too_close;
  bool has_demands = true;   // on angles and sizes; without them the run is not complete
  bool is_as_given = false;  // the metric given is the same everywhere, wherever it was looked at
  double angle_bound = 0;    // degrees: the one asked for
};

// Mesh that a run made, how the run ended, and what it took.
struct mesh_outcome {
  // True if the mesh meets the demands, as the mesher believes; the auditor decides.
  bool complete = false;
  bool stopped = false;     // by options.stop
  refinement_ending ended;  // of the refinement that made the mesh
  mesh result;
  std::size_t sites = 0, triangles = 0, disagreeing = 0, low_angle = 0, too_large = 0;
  bool jumps = false;  // some disagree where the metric jumps, or all but jumps
  std::size_t inserted = 0, splits = 0, candidates_rejected = 0;
  // Number of stars that a local search made wrongly, mended by a search of all
  // sites.
  std::size_t star_repairs = 0;
  std::vector<exempt_corner> exempt;
  std::vector<triangle> exempt_triangles;  // of result.triangles, below the bound at or across them
  tier_counters counters;
  std::optional<improvement_report> improved;  // where passes were asked for and it is complete
  // Set if the mesh is in one metric for all sites; `delivered` has its distance from the one
  // wanted, unless both are equal.
  std::optional<constant_metric_report> one_metric;
  // Set if refinement in one metric for all sites was tried and stopped: how that refinement ended.
  // The mesh is then in the metric given, and `ended` states how refinement in that metric ended.
  std::optional<refinement_ending> stopped_in_one_metric;
  // Distance of the mesh's metric from the one wanted; set if the mesh was made by local changes,
  // or in one metric for all sites.
  std::optional<delivered_report> delivered;
  // Set if only a metric beyond the tolerance led to a mesh. With a tolerance of 0 this mesh is in
  // the metric wanted, else in the metric beyond the tolerance.
  std::optional<intolerable_distance> intolerable;
  // Attempts of the run, in order, and the one that made this mesh; set by make_mesh
  // alone.
  std::vector<attempt_report> tried;
  std::optional<mesh_attempt> chosen;
  // The audit of the mesh, if the mesher ran it already: with the angle bound and the domain of the
  // run, no corner exempt, and no check of the Voronoi diagram.
  std::shared_ptr<const past_audit> audited;

  // Returns how the run as a whole ended, also where the refinement of its mesh ended otherwise.
  ending how() const {
    if (one_metric) return ending::one_metric;
    if (stopped) return ending::stopped;
    if (intolerable) return ending::intolerable;
    return ended.length_factor > 1 ? ending::site_limit : ended.how;
  }
};

}  // namespace asterism
