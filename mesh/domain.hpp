// SPDX-License-Identifier: MIT
//
// What is to be meshed: a planar straight-line graph whose segments bound the domain, with holes.
//
// Source: the thesis's "input domain" (chapter 4), in the shape of Triangle's .poly files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {

using index = std::uint32_t;

// Vertices of `domain::vertices`; `marker` is carried to the mesh's boundary edges.
struct segment {
  index a = 0, b = 0;
  int marker = 0;
};

struct bounding_box {
  point low, high;
};

// Where a domain was read, so that messages about it can use its author's numbers and lines.
// Default-constructed for a domain that did not come from a file: numbers then start at 1.
struct domain_origin {
  std::string file;         // with the segments and holes
  std::string vertex_file;  // the same one, or Triangle's separate .node file
  int first_number = 1;     // of vertices and segments: 0 or 1
  std::vector<std::size_t> vertex_lines, segment_lines, hole_lines;
};

// After `check_domain` (mesh/domain_check.hpp) accepted it:
//  - segments meet only at common vertices, no two vertices coincide;
//  - every segment has the inside of the domain on exactly one side, which is its left: segments
//    are oriented so that the domain lies to the left of a -> b;
//  - every vertex that is on no segment lies strictly inside: it becomes a site of the mesh.
struct domain {
  std::string name;
  std::vector<point> vertices;
  std::vector<segment> segments;
  std::vector<point> holes;  // one point inside each hole
  domain_origin origin;

  // The smallest box around all vertices; a box of the origin alone when there are none.
  bounding_box box() const;
};

}  // namespace asterism
