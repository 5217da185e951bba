// SPDX-License-Identifier: MIT
//
// Makes the next mesh of an adaptation loop, in the metric given at the vertices of the present
// one.
//
//   const auto wanted = make_solution_metric(old.subject, fields, wishes);
//   for (std::size_t v = 0; v < old.subject.sites.size(); ++v)
//     old.subject.sites[v].metric = wanted.value().tensors[v];
//   const auto next = adapt_to_metric(old, options);
//   const auto values = transfer_solution(old.subject, u, next.value().made.outcome.result, how);
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/periodic_mesh.hpp"

namespace asterism {

// Rule for the given mesh to stay as it is: where it is as good as a new one, never, or wherever it
// is certified in the metric, whatever the lengths of its edges.
enum class keep_rule { automatic, never, always };

// Largest limit on sites of a run for which no limit was given.
inline constexpr std::size_t most_sites_unasked = 10000000;

// Demands of an adaptation other than its metric.
struct mesh_adaptation_options {
  double corner_angle = 30;  // degrees: where the boundary turns by more it keeps its vertex
  // The exact domain, as check_domain accepts it, used instead of the domain that the mesh covers.
  // Its curves are divided anew, for the metric.
  std::optional<domain> exact = {};
  // Greatest distance of the new boundary from that of the mesh, both ways, where there is no
  // `exact`. Default: parts of lengths where vertices are removed, and the distance of cubics
  // through the vertices where some are added.
  std::optional<double> largest_boundary_distance = {};
  // The part of the size wanted across the boundary, and of a piece's length, above 0 and at most
  // 1/8. Default: those of outline_options.
  std::optional<double> boundary_part = {};
  // Greatest distance of a curve of `exact` from its chords; default: curve_division's.
  std::optional<double> chord_tolerance = {};
  // Options of the new mesh; limit_size is set by the run. Without `vertices` the mesh has the
  // number of vertices that unit edges take, the boundary's included.
  mesh_options refinement = {};
  keep_rule keep = keep_rule::automatic;
  // Pairs of sides that must have the same points, by their markers; a mesh whose sides do not
  // match does not stay.
  std::vector<periodic_pair> periodic = {};
  // True to have no inner edge that joins two vertices of the boundary, and so no triangle with all
  // three of its vertices there.
  bool no_split_across = false;
  // True to keep max_sites as given. Otherwise it is raised to three times the number of vertices
  // wanted, but to no more than most_sites_unasked, nor, if the metric alone sets the number, ten
  // times the vertices of the mesh.
  bool keeps_site_limit = false;
};

// The next mesh of an adaptation, and how it relates to the given one.
struct adapted_mesh {
  domain shape;  // what it is a mesh of
  certified_mesh made;
  // The result has the triangles of the mesh given: that one stays, or a new mesh is the same.
  bool kept = false;
  std::size_t boundary_vertices = 0;  // of the mesh given
  std::size_t boundary_kept = 0;      // of those
  bool keeps_boundary = false;        // all of them, because parts touch
  // The given mesh's boundary along the segments of the domain, and the proved bound of the new
  // boundary's distance from it, both ways; none with an exact domain. Part of the claim.
  std::optional<former_boundary> former = {};
  double boundary_distance = 0;
  // Cracks of the mesh given. `made` has one vertex at each place, and their edges as segments
  // inside: domain/cracks.hpp parts it.
  crack_markers cracks = {};
};

// Makes the mesh. The metric is that of `from`'s sites. Its domain is the exact one, or that of the
// mesh (mesh/domain/mesh_outline.hpp). A mesh that is certified in its metric with the angle bound
// wanted stays as it is if it is as good as a new one: with the number of vertices that was named,
// to 2 %, or else the one that its metric asks for, to a tenth, and with lengths as a new mesh has
// them (95 edges of a hundred within a factor of sqrt 2 of one, none below a third or above 1.75,
// or no worse than those of a new mesh made for comparison). So adapting twice with the metric
// delivered changes nothing. Fails for a mesh that is no triangulation.
ASTERISM_EXPORT result<adapted_mesh> adapt_to_metric(const marked_mesh& from,
                                                     const mesh_adaptation_options& options,
                                                     const progress_listener& progress = {});

}  // namespace asterism
