// SPDX-License-Identifier: MIT
//
// Keeps the subsegments of a domain that is being filled: each segment is halved, again and again,
// at the points of its division.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/fill/placed_sites.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/metric/field_sampler.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {

class segment_intervals {
 public:
  // Makes an empty list. `d` and the sites must outlive this object.
  segment_intervals(const domain& d, std::vector<division> divisions, const placed_sites& sites);

  // Adds one undivided interval for each segment. The first sites must be the domain's vertices.
  void start();
  // Halves intervals until none is longer than `longest`, as far as the divisions go. Ends early
  // where the field fails or there is no room for a site.
  void halve(double longest, placed_sites& sites, field_sampler& sampler);

  // True if no subsegment has its bisector point nearer to s than to its ends. Tests only
  // subsegments within `distance` of s, and adds their number to `looked_at`.
  bool stays_clear(const site& s, double distance, std::uint64_t& looked_at) const;

  // Returns the metric length of the longest segment; 0 when there is none.
  double longest_segment() const;
  // Returns the sites that divide each segment, in its direction, ends left out.
  std::vector<std::vector<vertex_index>> dividing_sites() const;

 private:
  // Part of a segment between two points of its division, not necessarily adjacent ones: a present
  // subsegment.
  struct interval {
    std::size_t segment, first, last;  // into the division's points
    vertex_index a, b;
  };

  void insert(const interval& one);
  void index(std::size_t i);
  bounding_box box_of_interval(const interval& one) const;

  const domain* domain_;
  const placed_sites* sites_;
  std::vector<division> divisions_;
  std::vector<interval> intervals_;
  box_index index_;
  std::vector<std::vector<vertex_index>> at_division_;  // the site at each point of a division
};

}  // namespace asterism::internal
