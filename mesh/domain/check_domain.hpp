// SPDX-License-Identifier: MIT
//
// Establishes, by exact signs alone, the properties of a domain that a mesher relies on. A planar
// straight-line graph is put in order where that changes no point set, and refused where its
// meaning is unclear.
//
// Put in order, and counted in the report:
//  - vertices with identical coordinates are merged (the first one stays);
//  - segments without length are dropped;
//  - a segment with vertices exactly on it is split there, so that segments which overlap share
//    subsegments; subsegments that occur several times are kept once, with the first marker that is
//    not 0;
//  - the outside is removed from the plane, and so is every face with a hole point in it (faces of
//    the arrangement, as Triangle does; not the even-odd rule: a ring inside another one, with no
//    hole point in it, divides the domain); segments with the domain on neither side are dropped,
//    those with the domain on one side are oriented with the domain on their left, those with the
//    domain on both are internal and keep their direction;
//  - where the domain has polygons (data/domain_polygon.hpp), every face is removed that none of
//    them contains, too; a face that several features contain has the least of their numbers;
//  - vertices on no segment are kept when strictly inside the domain, and dropped otherwise;
//  - the faces that are left are given the numbers of the region points in them (data/domain.hpp);
//  - limits on the area of a region's triangles are dropped: size is the metric's.
//
// Refused, naming the part, in the numbers and lines of the file the domain came from:
//  - coordinates that are not finite, segments whose vertices do not exist;
//  - two segments that cross in a point inside both: the point is in general no double;
//  - a chain of segments that ends alone in a hole or outside: a ring that is not closed. (A chain
//    may end alone inside the domain. A segment that is traced there and back, as a ring with a
//    spike does, ends nothing.)
//  - a hole or region point on a segment or outside, a region point in a hole, two region points
//    with different numbers in one face;
//  - a polygon's ring that is not closed, or has a segment that does not exist;
//  - a curve without chords (domain/divide_curves.hpp), or with a chord that is cut by a vertex on
//    it, covered by another segment, or dropped alone;
//  - a domain of which no face is left.
//
// Hole points whose hole has become one with the outside are dropped silently.
// A domain that was accepted once is accepted again, unchanged. Rings may touch in vertices and the
// domain may fall into several parts. Time: O(n log n + n k) for n segments in k rings, holes and
// loose vertices, plus the pairs of segments whose x ranges overlap.
// Source: Shewchuk, "Triangle", section on holes and concavities, for what holes mean.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/domain_repairs.hpp"

namespace asterism {

// Returns the domain put in order, or refuses it. `repairs`, when given, is overwritten.
ASTERISM_EXPORT result<domain> check_domain(const domain& input, domain_repairs* repairs = nullptr);

}  // namespace asterism
