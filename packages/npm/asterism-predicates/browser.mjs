// SPDX-License-Identifier: MIT
import { create } from './api.mjs';

const response = await fetch(new URL('./predicates.wasm', import.meta.url));
if (!response.ok) throw new Error(`asterism-predicates: ${response.url}: ${response.status} ${response.statusText}`);
const predicates = await create(await response.arrayBuffer());

export const {
  orientation, isPositiveDefinite, compareDistance, inWedge, dominates, voronoiVertexCount, arcIntersectionCount,
  encroaches, insertionTest, edgeTest, inCircle,
  orientations, arePositiveDefinite, compareDistances, inWedges, dominations, voronoiVertexCounts,
  arcIntersectionCounts, encroachments, insertionTests, edgeTests, inCircles,
  orient2d, incircle, explain, counters, resetCounters, version,
} = predicates;
