// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/audit_report.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace asterism {

const std::array<std::string_view, finding_kind_count> finding_kind_names = {
    "invalid_option",
    "empty_mesh",
    "disagreeing_triangles",
    "index_out_of_range",
    "not_finite",
    "metric_not_positive_definite",
    "repeated_position",
    "repeated_corner",
    "repeated_triangle",
    "orientation",
    "repeated_edge",
    "unmatched_edge",
    "boundary_without_triangle",
    "boundary_inside",
    "repeated_boundary",
    "open_boundary",
    "boundary_contact",
    "wrong_winding",
    "unused_vertex",
    "broken_fan",
    "given_changed",
    "segment_not_covered",
    "marker_changed",
    "side_changed",
    "boundary_deviation",
    "curve_deviation",
    "wrong_region",
    "angle_below_bound",
    "collateral_angle_below_bound",
    "exemption_not_proven",
    "nothing_judged",
    "star_neighbour_rejected",
    "star_site_missing",
    "stopped",
    "voronoi_vertex_missing",
    "voronoi_arc_reversed",
    "voronoi_site_nearer",
    "voronoi_boundary_encroached",
};

const std::array<std::string_view, 4> voronoi_verdict_names = {"not asked", "not reached",
                                                               "refused", "proved"};

std::size_t audit_report::total_found() const {
  return std::accumulate(found.begin(), found.end(), std::size_t{0});
}

std::vector<vertex_index> audit_report::refused_triangles() const {
  std::vector<vertex_index> all;
  std::set_union(low_triangles.begin(), low_triangles.end(), collateral_triangles.begin(),
                 collateral_triangles.end(), std::back_inserter(all));
  return all;
}

}  // namespace asterism
