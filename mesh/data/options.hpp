// SPDX-License-Identifier: MIT
//
// Holds the options of a meshing run, and the progress it reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// The thesis's two heuristics, and `fill`: with a size limit the domain is filled first
// (fill/fill.hpp), then defects are mended at candidates of the arcs, and in the end every star is
// tested against all sites.
enum class refinement_strategy { voronoi_arcs, poisson_darts, fill };

// Options of a meshing run.
struct mesh_options {
  double angle_bound = 20;  // degrees, 0 <= bound < 60; measured from all three vertices
  refinement_strategy strategy = refinement_strategy::fill;
  // Least length from a new site to any other, in the metrics of both. Poisson darts
  // (refine/poisson_darts.hpp) start from this length and shrink it. Default: chosen from the
  // domain (refine/insertion_tolerance.hpp) and reported in the outcome.
  std::optional<double> tolerance = {};
  // A triangle is too large when its sites are farther than 0.75 metric units from their nearest
  // common Voronoi vertex, a boundary subsegment when it is longer than 1.2: edges then come out
  // around length 1. Checked only when set (the command line sets it when --size is given).
  bool limit_size = false;
  // Number of vertices wanted, within some percent; the length of edges follows from it. Met where
  // the metric is given on a mesh (delivery/metric_delivery.hpp); elsewhere the metric decides
  // alone.
  std::optional<std::size_t> vertices = {};
  std::size_t max_sites = 100000;
  // Keeps the domain's vertices as the only sites, and its segments whole, if no triangle of their
  // stars has to be mended. For a domain that is a mesh already.
  bool keep_if_complete = false;
  cancellation stop = {};  // polled during the run; what it says becomes part of the outcome
  int max_rejected = 100;  // darts in a row before the tolerance shrinks
  std::uint64_t seed = 1;  // darts
  // Largest number of passes that improve a complete mesh (pipeline/improved_mesh.hpp). Each pass
  // refines anew. Default 0.
  std::size_t improve_passes = 0;
  // Greatest distance allowed between the metric delivered and the one wanted, at any site: ln of
  // the greatest ratio of the two lengths of a displacement, as delivered_report::greatest. 0: no
  // tensor is changed, and where stars cannot agree in the metric wanted a run ends with triangles
  // that disagree. If the distance is greater, a run is not complete, and reports the distance.
  // Default: any distance is allowed, unless that of half of the sites exceeds
  // most_median_distance, or the ratio of the two complexities most_density_ratio
  // (data/delivered_report.hpp).
  std::optional<double> metric_tolerance = {};
  // Has make_certified_mesh prove or refuse that the mesh is the dual of the anisotropic Voronoi
  // diagram of its sites. make_mesh ignores it.
  bool prove_voronoi = false;
};

// The phase of a run. While filling, sites are being proposed, and no triangle is known
// yet.
enum class mesh_phase { filling, refining, auditing };

// State of a run, reported from time to time.
struct mesh_progress {
  mesh_phase phase = mesh_phase::refining;
  std::size_t sites = 0, disagreeing = 0, low_angle = 0, too_large = 0;
  double sites_expected = 0;  // while filling, about; 0 when that cannot be told yet
};

// Function called from time to time by the thread that started the run; may be empty.
using progress_listener = std::function<void(const mesh_progress&)>;

}  // namespace asterism
