// SPDX-License-Identifier: MIT
//
// Exports the instance of node.cjs, so that a program has one instance however it imports it.
import predicates from './node.cjs';

export const {
  orientation, isPositiveDefinite, compareDistance, inWedge, dominates, voronoiVertexCount, arcIntersectionCount,
  encroaches, insertionTest, edgeTest, inCircle,
  orientations, arePositiveDefinite, compareDistances, inWedges, dominations, voronoiVertexCounts,
  arcIntersectionCounts, encroachments, insertionTests, edgeTests, inCircles,
  orient2d, incircle, explain, counters, resetCounters, version,
} = predicates;
