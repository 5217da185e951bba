// SPDX-License-Identifier: MIT
//
// Finds where to split the segments of narrow wedges. A wedge is two segments at a sharp corner,
// over their whole length. In a narrow wedge each split of one segment encroaches on the other.
// Splits at equal distances from the corner on both segments end this (docs/design/refinement.md,
// "Corners").
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/stars/boundary.hpp"

namespace asterism::internal {

// An angle of the domain below 180 degrees between two neighbouring input segments at a domain
// vertex. Its directions never change, so neither does its angle.
struct domain_corner {
  vertex_index vertex = 0;
  std::size_t sector = 0;  // which of the vertex's corners and sectors
  double angle = 0;        // degrees, as the vertex measures it

  // True if the angle is below 60 degrees.
  bool is_sharp() const { return angle < 60; }
};

// Two input segments that meet in a sharp corner with nothing between them, over their whole
// length, not only at the first subsegments.
struct domain_wedge {
  domain_corner corner;
  vertex_index first = 0, last = 0;          // the segments, counter-clockwise
  vertex_index first_end = 0, last_end = 0;  // their vertices other than the corner
  bool internal = false;                     // true if either of them is
};

class narrow_wedges {
 public:
  narrow_wedges() = default;
  // Starts without wedges. `edges` must not be split yet.
  explicit narrow_wedges(const boundary& edges);
  // Adds the wedge of a sharp corner, whose subsegments leave it and enter it.
  void add(const domain_corner& c, const boundary_edge& leaving, const boundary_edge& entering);
  // Records that site v splits a segment.
  void note_split(vertex_index v, vertex_index segment);

  const std::vector<domain_wedge>& all() const { return wedges_; }
  // True if the segment is one of a narrow wedge inside the domain. For other segments
  // mirrored_point() never has a point.
  bool is_mirrored(vertex_index segment) const;
  // Returns the wedges one of whose segments the site splits.
  std::vector<const domain_wedge*> at_split(vertex_index v) const;
  // Returns the first wedge for which accepts() is true and whose two segments hold all three
  // corners of the triangle, at least one of them a point that splits a segment; none if there is
  // none. Each segment must hold a corner of the triangle that is not the wedge's.
  const domain_wedge* across(const triangle& t,
                             const std::function<bool(const domain_wedge&)>& accepts) const;

  // Returns the point of the subsegment that is as far from the corner of a narrow wedge as the
  // encroacher on its other segment; none where there is no such wedge or point.
  std::optional<point> mirrored_point(const std::vector<site>& sites,
                                      const boundary_edge& subsegment,
                                      vertex_index encroacher) const;
  // Returns where to split a subsegment of a narrow wedge beyond the first one: at a round distance
  // from the corner, so that both segments of the wedge are split alike. Of two corners the nearer
  // counts. None for other subsegments.
  std::optional<point> split_point(const std::vector<site>& sites,
                                   const boundary_edge& subsegment) const;

 private:
  struct segment_ends {
    vertex_index a = 0, b = 0;
    bool internal = false;
  };

  bool is_split(vertex_index v) const { return v < split_segment_.size() && split_segment_[v]; }

  std::vector<segment_ends> segments_;
  std::vector<domain_wedge> wedges_;
  std::vector<std::vector<std::size_t>> wedges_of_segment_;
  std::vector<std::optional<vertex_index>> split_segment_;  // by site: the segment it splits
};

// True if the angle between the wedge's segments is certainly below `degrees` as v measures it.
// False where that is not certain.
bool is_narrower(const std::vector<site>& sites, const domain_wedge& w, vertex_index v,
                 double degrees);

}  // namespace asterism::internal
