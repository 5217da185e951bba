// SPDX-License-Identifier: MIT
//
// Holds the options of an audit, its findings and its measurements
// (mesh/audit/audit.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// Kinds of findings against a mesh.
enum class finding_kind : std::size_t {
  invalid_option,                // the audit was asked something it cannot answer
  empty_mesh,                    // no triangle
  disagreeing_triangles,         // the mesh itself says that stars disagree
  index_out_of_range,            //
  not_finite,                    // a coordinate or metric entry
  metric_not_positive_definite,  //
  repeated_position,             // two vertices at the same point
  repeated_corner,               // a triangle or subsegment that names a vertex twice
  repeated_triangle,             // same three vertices
  orientation,                   // clockwise or flat triangle
  repeated_edge,                 // a directed edge of two triangles
  unmatched_edge,                // no triangle across, and no boundary subsegment
  boundary_without_triangle,     // no triangle left of a subsegment, or right of an internal one
  boundary_inside,               // a subsegment that is not internal with a triangle on its right
  repeated_boundary,             // two equal subsegments
  open_boundary,                 // subsegments arriving at a vertex and leaving it differ in number
  boundary_contact,              // two subsegments cross or touch other than in a common end
  wrong_winding,                 // the boundary encloses its left side not exactly once
  unused_vertex,                 // a site in no triangle
  broken_fan,                    // the triangles at a vertex do not surround it once
  given_changed,                 // sites[0 .. given) are not the domain's vertices
  segment_not_covered,  // the subsegments of a segment do not lead from its start to its end
  marker_changed,       // a subsegment has another marker than its segment
  side_changed,         // a subsegment is internal and its segment is not, or the reverse
  boundary_deviation,   // a split point too far from its segment for rounding
  curve_deviation,      // a curve that the boundary does not follow, or off which a vertex is
  wrong_region,         // a triangle does not have the number of its region
  angle_below_bound,    //
  collateral_angle_below_bound,  // another one at a sharp corner, or across a narrow wedge
  exemption_not_proven,          // the corner's own angle is not below the bound
  nothing_judged,                // most triangles are exempt, and between segments on all sides
  star_neighbour_rejected,       // a neighbour the star would not accept again
  star_site_missing,             // a visible site the star would accept
  stopped,                       // the stars were not all looked at
  // The last four kinds refuse point 5 (the dual of the Voronoi diagram) alone.
  voronoi_vertex_missing,       // a triangle without a Voronoi vertex that its corners all see
  voronoi_arc_reversed,         // Voronoi vertices in the wrong order around an edge
  voronoi_site_nearer,          // a third site nearer to a point of an arc
  voronoi_boundary_encroached,  // a third site nearer to a point of a boundary edge
};
// Number of kinds of findings.
inline constexpr std::size_t finding_kind_count = 38;
// Names of the kinds of findings as certificates spell them, in the order of `finding_kind`.
ASTERISM_EXPORT extern const std::array<std::string_view, finding_kind_count> finding_kind_names;

// One finding. `witness` is one sentence that names vertices, triangles and boundary subsegments,
// all counted from audit_options::first_number, with their coordinates.
struct audit_finding {
  finding_kind kind{};
  std::string witness;
  // Vertices of a finding about a star, counted from 0: its centre, the neighbour or site that is
  // missing, and the neighbours before and after that. Empty for other findings.
  std::vector<vertex_index> vertices = {};
};

// Questions that an audit answers, and limits on what it reports.
struct audit_options {
  // Angle bound in degrees, 0 <= bound < 90. Empty: angles are measured and compared with no bound.
  std::optional<double> angle_bound;
  // Corners (indices from 0) at which the domain may be sharper than the bound. Each must be
  // proven: the angle of the domain at it, in its own metric, is below the bound.
  std::vector<vertex_index> exempt_corners;
  // True to search for corners whose exemption can be proven, and to exempt all of them, also those
  // not in exempt_corners.
  bool find_exempt_corners = false;
  // The domain as it was meshed (after check_domain); not owned, may be null.
  const domain* original = nullptr;
  // True if the domain is read off the mesh itself, none being given. A mesh of which every inner
  // edge is a segment is then refused where any angle is exempt; any other mesh as
  // check_something_judged says.
  bool domain_is_the_mesh = false;
  bool check_stars = true;
  // True to check stars with the auditor's own filter and edge_test alone. Otherwise the kernel's
  // prepared gaps, faster and shared with the mesher, are evaluated first. The kernel bounds the
  // reach of a gap in both cases, if the filter does not.
  bool own_filter_alone = false;
  bool check_voronoi = false;
  // Polled while stars are checked; a stop ends that check, and the stars then count as not
  // checked. Its account is charged with the audit's work.
  cancellation stop = {};
  // Number of findings kept of each kind; further ones are counted only.
  std::size_t findings_kept = 10;
  // Number of the first vertex, triangle and boundary subsegment in witnesses: 1 as in a .mesh
  // file, or 0 as in arrays. Certificates have witnesses from 1 alone.
  int first_number = 1;
};

// The verdict on point 5, the dual of the Voronoi diagram.
enum class voronoi_verdict : std::size_t {
  not_asked,
  not_reached,  // the mesh is no triangulation of a region, or was not looked at so far
  refused,      // the findings say why
  proved,
};

// Names of the verdicts on point 5 as certificates spell them, in the order of the enumeration.
ASTERISM_EXPORT extern const std::array<std::string_view, 4> voronoi_verdict_names;

// The least angle of one kind and its place, in degrees; computed in floating point, for
// information.
struct audited_angle {
  double degrees = 180;
  vertex_index triangle = 0, corner = 0,
               perspective = 0;  // indices from 0; the last two are vertices
};

// How the boundary of a mesh follows the curves of its domain.
struct curve_report {
  std::size_t curves = 0;
  // Numbers of mesh vertices that are on curves but for rounding, counted once for each curve, and
  // of vertices that split a chord and are on the chord, but for rounding, in place of the curve.
  std::size_t vertices = 0, off_curve = 0;
  // Upper bound, in units of the domain, of the distance between a curve and the boundary along it,
  // from any point of either to the other.
  double largest_distance = 0;
};

// Findings and measurements of an audit.
struct audit_report {
  bool certified = false;  // points 0 to 4, as far as asked for
  voronoi_verdict voronoi = voronoi_verdict::not_asked;
  std::vector<audit_finding> findings;
  std::array<std::size_t, finding_kind_count> found{};  // number of each kind, kept or not

  std::size_t sites = 0, triangles = 0, boundary_subsegments = 0, given = 0;
  bool domain_checked = false;  // false: no domain was given
  bool angles_checked = false;  // false: no bound was given
  bool stars_checked = false;   // false: not asked for, or the mesh is no triangulation
  // True if the check of stars ended before all were checked, since enough findings refused the
  // mesh.
  bool stars_cut_short = false;

  // Every angle in each of three metrics is of one kind. Exempt are angles at a sharp corner, in
  // the corner's metric and in other metrics in which the domain's own angle there is below the
  // bound. Collateral are all other angles of triangles at a sharp corner, or across a narrow wedge
  // of which one side is internal. The rest are ordinary. Collateral and ordinary angles must meet
  // the bound.
  audited_angle worst_ordinary, worst_collateral, worst_exempt;
  // Returns the lesser of the least ordinary and the least collateral angle, in degrees: the angles
  // that must meet the bound.
  const audited_angle& worst() const {
    return worst_collateral.degrees < worst_ordinary.degrees ? worst_collateral : worst_ordinary;
  }
  std::vector<vertex_index> exempt_corners;  // proven, ascending
  // Indices of triangles with an angle of the kind below the bound, ascending; a triangle can be in
  // several lists.
  std::vector<vertex_index> exempt_triangles, collateral_triangles, low_triangles;
  // Returns the triangles in collateral_triangles or low_triangles, ascending, each
  // once.
  ASTERISM_EXPORT std::vector<vertex_index> refused_triangles() const;
  // Upper bound of the distance of a split point from its segment: in units of the domain, and in
  // units in the last place of the largest coordinate of the segment's ends.
  double largest_deviation = 0, largest_deviation_ulps = 0;
  curve_report curves;

  // Number of decisions made by the auditor's own arithmetic, and of those among them that needed
  // rationals; decisions of the kernel are in `counters`.
  std::size_t decisions = 0, exact_decisions = 0;
  std::size_t star_pairs = 0, star_pairs_tested = 0;  // pairs looked at, and left for edge_test
  // Number of tests of a site against a Voronoi arc, and of those among them that needed exact
  // numbers.
  std::size_t voronoi_pairs = 0, voronoi_pairs_exact = 0;
  tier_counters counters;

  ASTERISM_EXPORT std::size_t total_found() const;
};

}  // namespace asterism
