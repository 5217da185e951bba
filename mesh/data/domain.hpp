// SPDX-License-Identifier: MIT
//
// Describes the domain to be meshed: a planar straight-line graph. Its segments bound the domain,
// with holes, or lie inside it and become edges of the mesh.
//
// Source: the thesis's "input domain" (chapter 4), in the shape of Triangle's .poly files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/domain_curve.hpp"
#include "asterism/mesh/data/domain_polygon.hpp"

namespace asterism {

// Number of a vertex, site or triangle, counted from 0.
using vertex_index = std::uint32_t;

// A segment between two vertices of `domain::vertices`. `marker` is carried to the mesh's boundary
// edges. The other members are set by check_domain; their values before are ignored.
struct segment {
  vertex_index a = 0, b = 0;
  int marker = 0;
  bool internal = false;                  // the domain is on both sides
  int left_region = 1, right_region = 1;  // the domain's on that side; right only when internal
};

// A point that gives its region number to the part of the domain around it, up to the segments.
struct region_point {
  point at;
  int number = 0;
  double largest_area = 0;  // wanted of a triangle there, 0: no limit; check_domain drops it
};

// The files and lines that a domain was read from, so that messages about it can use its author's
// numbers and lines. Default-constructed for a domain that did not come from a file: numbers then
// start at 1.
struct domain_origin {
  std::string file;         // with the segments and holes
  std::string vertex_file;  // the same one, or Triangle's separate .node file
  int first_number = 1;     // of vertices and segments: 0 or 1
  std::vector<std::size_t> vertex_lines, segment_lines, hole_lines,
      region_lines = {}, curve_lines = {},
      curve_numbers = {};  // of the lines that the curves are of: a line may make several
  // Notes on what the reader changed or left out, a sentence each.
  std::vector<std::string> notes = {};
};

// A domain. After `check_domain` (mesh/domain/check_domain.hpp) accepted it:
//  - segments meet only at common vertices, no two vertices coincide;
//  - every segment has the domain on its left: on no other side when it is part of the boundary,
//    on both when it is internal (it may dangle, divide the domain or be a closed curve inside);
//  - every vertex that is on no segment lies strictly inside: it becomes a site of the mesh;
//  - the regions on the two sides of each segment are known. Without region points, and unless all
//    regions are to be numbered, every region is number 1. With them, a region without one is 0,
//    or, if all are to be numbered, gets the least positive number not yet taken.
struct domain {
  std::string name;
  std::vector<point> vertices;
  std::vector<segment> segments;
  std::vector<point> holes;  // one point inside each hole
  std::vector<region_point> regions;
  bool number_all_regions = false;
  domain_origin origin;
  // Curved parts of the boundary. Consecutive vertices of a curve are joined by a segment.
  std::vector<domain_curve> curves = {};
  // Polygons that define the inside, except for the areas around hole points; if empty, segments
  // define it.
  std::vector<domain_polygon> polygons = {};

  // Returns the smallest box around all vertices; a box of the origin alone when there are none.
  ASTERISM_EXPORT bounding_box box() const;
};

}  // namespace asterism
