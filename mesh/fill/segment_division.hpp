// SPDX-License-Identifier: MIT
//
// Divides the segments of the domain so that all subsegments are about equally long in the metric:
// the first step of filling a domain.
//
// Lengths are integrals along the segment, taken numerically in plain doubles: they decide where
// points are proposed, nothing else. The subsegments next to a vertex are about equally long on all
// its segments, as the vertex measures, so that subsegments meeting at a small angle end on one
// circle and do not encroach on each other.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

struct division {
  // The points of the division, both ends included, and their distances along the segment.
  std::vector<point> points;
  std::vector<double> lengths;
};

struct segment_divisions {
  double subsegments = 0;         // about how many there are in all
  std::vector<division> of_each;  // none when that is more than `most_points`
};

// Divides each segment of `d` so that none of its subsegments is much longer than `longest` (metric
// length). Fails where the field does, and where lengths leave the range of doubles.
result<segment_divisions> divide_segments(const domain& d, const metric_field& field,
                                          double longest, std::size_t most_points);

// Divides each segment of `d` into parts of equal metric length, except for the shift, with a
// length nearest to the geometric mean of `shortest` and `longest`: with a ratio of 1.2 all lengths
// are between the two if the segment is at least five times `shortest` long. Fails as
// divide_segments() does.
result<segment_divisions> divide_segments_evenly(const domain& d, const metric_field& field,
                                                 double shortest, double longest,
                                                 std::size_t most_points);

}  // namespace asterism::internal
