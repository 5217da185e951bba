// SPDX-License-Identifier: MIT
//
// Counts the repairs that were made when a domain was put in order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {

// A place where repair_domain changed the domain; `what` is one of "joined", "bent", "crossing",
// "trimmed", "hole dropped".
struct repair_place {
  std::string what;
  point at;
};

// Numbers of repairs, by kind.
struct domain_repairs {
  std::size_t merged_vertices = 0;
  std::size_t segments_without_length = 0;
  std::size_t split_segments = 0;        // had other vertices on them
  std::size_t repeated_subsegments = 0;  // subsegments that another segment had covered already
  std::size_t outer_subsegments = 0;     // had the domain on neither side
  std::size_t dropped_vertices = 0;
  std::size_t dropped_area_limits = 0;
  std::size_t flat_rings = 0;    // of polygons, which enclose nothing
  std::size_t shared_parts = 0;  // that several features contain
  // Numbers of repairs that only repair_domain makes.
  std::size_t joined_vertices = 0;    // nearer than `distance` to another one, and not at its place
  std::size_t bent_segments = 0;      // passed a vertex within half the distance
  std::size_t crossings = 0;          // that became vertices
  std::size_t trimmed_segments = 0;   // went on past the boundary that they crossed
  std::size_t dropped_holes = 0;      // nearer than the distance to a segment
  double distance = 0;                // 0: nothing of the kind was asked for
  double greatest_move = 0;           // of a vertex or a point of a segment, in doubles
  std::vector<repair_place> places;   // of all of these, in the order of the counts
  std::vector<std::string> messages;  // one a kind that occurred, with a count and the first case

  bool any() const { return !messages.empty(); }
};

}  // namespace asterism
