// SPDX-License-Identifier: MIT
//
// Finds and proves the corners at which the domain itself is sharper than the angle bound, and the
// triangles beside them; inside the auditor alone.
//
// No mesh has a larger angle at such a corner, in a metric that measures the domain's angle there
// below the bound: the triangles only divide it. That angle alone is excused. Other low angles in
// the same triangles, or in those across a narrow wedge between segments, are collateral: likely
// where a corner is very sharp, but avoidable in principle.
#pragma once

#include <tuple>
#include <vector>

#include "asterism/mesh/audit/corner_angle.hpp"

namespace asterism::internal::audit_detail {

// A sector of the domain at a corner, proven to be narrower than the bound in the corner's metric.
struct narrow_sector {
  vertex_index at = 0, first = 0, last = 0;
};

// A sector narrower than half the bound, with a segment inside the domain as one of its sides,
// followed to the given vertices at the far ends of its two segments. Vertices between these ends
// are in wedge_points.
struct narrow_wedge {
  vertex_index at = 0, first_end = 0, last_end = 0;
};

// Records that a vertex other than the corner is on a segment of a wedge.
struct wedge_point {
  vertex_index vertex = 0;
  std::size_t wedge = 0;
  bool last = false;  // on which of the two segments

  friend bool operator<(const wedge_point& l, const wedge_point& r) {
    return std::tie(l.vertex, l.wedge, l.last) < std::tie(r.vertex, r.wedge, r.last);
  }
};

struct narrow_wedges {
  std::vector<narrow_wedge> list;
  std::vector<wedge_point> points;  // sorted
};

// Returns the narrow sectors, ordered by corner: of the corners claimed, or of all corners where
// the options look for them. Reports proven corners, and claims that are not proved.
std::vector<narrow_sector> find_narrow_sectors(audit_context& context,
                                               const squared_cotangent& bound);

narrow_wedges find_narrow_wedges(audit_context& context, const std::vector<narrow_sector>& sectors,
                                 const squared_cotangent& half);

// Returns the sector at v in which the triangle lies, or null.
const narrow_sector* sector_of(const audit_context& context, const filtered_kernel& kernel,
                               const triangle& t, vertex_index v,
                               const std::vector<narrow_sector>& sectors);

// True if all corners of the triangle are on the two segments of one wedge, some on each, and the
// wedge is proven to be narrower than the bound as all three of them measure it.
bool crosses_narrow_wedge(const audit_context& context, audit_tally& tally, const triangle& t,
                          const narrow_wedges& wedges, const squared_cotangent& bound);

}  // namespace asterism::internal::audit_detail
