// SPDX-License-Identifier: MIT
//
// Judges a mesh and metric from elsewhere: is it the mesh of its stars, and does it meet the angle
// bound?
//
// The domain is the area that the boundary edges enclose, every vertex is a site, and the metric of
// a vertex is that site's. The stars of all sites are built, each from all sites visible from its
// own. A triangle counts when it is in the stars of its three vertices (thesis, definition 9). The
// audit judges the same mesh without building any star: two routes to one answer.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/region_areas.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// A mesh from elsewhere, put in order, and the domain it covers.
// A mesh with slits and cracks has one vertex at each place in it, and their edges inside are
// segments (domain/cracks.hpp).
struct adopted_mesh {
  mesh subject;  // every site is given, each boundary edge its own segment, domain on its left
  domain shape;  // of the subject; as check_domain would have it if the audit finds a triangulation
  crack_markers cracks = {};
  std::vector<vertex_index> number = {};  // of each vertex as it came; empty where none went
  int first_number = 1;  // of vertices and triangles in messages (audit_options::first_number)
};

// Treatment of two vertices at one place: they are joined to one, or refused.
enum class slit_rule {
  refused,
  joined  // where they are of both sides of a slit: for whoever parts the mesh again
};

// Treatment of edges that lie between triangles of different regions and are not listed.
enum class region_edges {
  segments,   // of marker 0, with a note: of a mesh that is a domain
  as_listed,  // no segments, so that an audit finds the regions wrong: of a mesh that is judged
};

// Puts a mesh in order. Its boundary edges are kept, turned where the only triangle is on their
// right; if it lists none, the edges with one triangle are taken, with marker 0. Regions are kept
// as they are. Fails, naming the number of the offender, if there is no triangle, for vertices
// that do not exist, for two at one place if `slits` refuses them, for numbers that are not
// finite, for tensors that are not positive definite, and if regions and triangles differ in
// number. Numbers in messages count from `first_number`.
ASTERISM_EXPORT result<adopted_mesh> adopt_mesh(mesh from_elsewhere,
                                                region_edges between = region_edges::segments,
                                                slit_rule slits = slit_rule::refused,
                                                int first_number = 1);

// Judgement of a mesh from elsewhere.
struct certify_report {
  audit_report audit;
  std::size_t inverted = 0;  // or flat triangles
  // Number of triangles in the stars of 0, 1, 2 and all 3 of their vertices.
  std::array<std::size_t, 4> in_stars{};
  std::vector<vertex_index> not_in_all;  // triangles, ascending
  std::size_t unsettled = 0;             // stars that met the bound of their construction
  // True if the stars were compared. False if the mesh is no triangulation, if its stars were not
  // made because of many findings, or if making them exceeded the work limit.
  bool compared = false;
  // Triangles with an angle below the bound by the metric of any of their vertices, exempt and
  // collateral ones included; inverted and flat triangles have no angles.
  std::size_t below_bound = 0;
  std::size_t edges = 0, unit_edges = 0;
  double mean_length = 0;            // of the edges, in the metric; 0: there are none
  std::vector<region_area> regions;  // empty where there is but region 1
  // Measurements for the theorem on nets; set for a certified mesh.
  std::optional<theorem_hypotheses> theorem;

  // True if the auditor certifies the mesh: the answer that `verify` gives. Newly built stars may
  // differ from the mesh where arcs are not wedged; `in_stars` has that comparison.
  bool certified() const { return audit.certified; }
  bool is_triangulation() const {
    return audit.stars_checked || audit.found[static_cast<std::size_t>(finding_kind::stopped)] != 0;
  }
};

// Returns the options of the audit of a mesh that brings its own domain, without the angle bound;
// refers to `adopted`.
ASTERISM_EXPORT audit_options questions_for(const adopted_mesh& adopted);

// Builds the stars, compares and audits. An edge is a unit edge if its length, the mean of those in
// the metrics of its two ends, is in [1/sqrt 2, sqrt 2]. 0 <= angle_bound < 60, degrees. With
// `check_voronoi` the audit also decides whether the mesh is the dual of the Voronoi diagram (point
// 5 of mesh/audit/audit.hpp); certified() does not depend on that. `stop` is polled during the
// judgement, and can end it.
ASTERISM_EXPORT certify_report certify(const adopted_mesh& adopted, double angle_bound,
                                       bool check_voronoi = false,
                                       std::size_t findings_kept = audit_options{}.findings_kept,
                                       const cancellation& stop = {});

}  // namespace asterism
