// SPDX-License-Identifier: MIT
//
// The instance of node.cjs, so that a program has one, however it is imported.
import predicates from './node.cjs';

export const {
  orientation, isPositiveDefinite, compareDistance, inWedge, dominates, voronoiVertexCount, arcIntersectionCount,
  encroaches, insertionTest, edgeTest, inCircle,
  orientations, arePositiveDefinite, compareDistances, inWedges, dominations, voronoiVertexCounts,
  arcIntersectionCounts, encroachments, insertionTests, edgeTests, inCircles,
  orient2d, incircle, explain, counters, resetCounters, version,
} = predicates;
