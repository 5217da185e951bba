// SPDX-License-Identifier: MIT
//
// Overrides robust-predicates by asterism-predicates. delaunator and d3-delaunay then ask the
// latter, by import and by require(), and triangulate. (d3-delaunay 6.0.6 contains a copy of
// robust-predicates.)
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { Delaunay } from 'd3-delaunay';
import Delaunator from 'delaunator';
import { counters, edgeTest, resetCounters } from 'robust-predicates';

assert.equal(typeof edgeTest, 'function');
assert.equal(createRequire(import.meta.url)('robust-predicates').edgeTest, edgeTest);
const points = Array.from({ length: 400 }, (_, k) => [k % 20, Math.floor(k / 20)]);
for (const triangulate of [Delaunator.from, Delaunay.from]) {
  resetCounters();
  assert.equal(triangulate(points).triangles.length, 3 * 2 * 19 * 19);
  const { semiStatic, interval, exact } = counters().orientation;
  assert.ok(semiStatic + interval + exact > 400);
}
console.log('delaunator and d3-delaunay ask asterism-predicates');
