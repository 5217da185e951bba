// SPDX-License-Identifier: MIT
//
// The interface of asterism-predicates in node: shapes of arguments, refusals, tiers, loading in all ways.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import test from 'node:test';
import * as predicates from 'asterism-predicates';
import { create, createSync } from 'asterism-predicates/api';

const require = createRequire(import.meta.url);
const { orientation, orientations, inCircle, edgeTest, edgeTests, compareDistance, explain } = predicates;
const table = (...numbers) => new Float64Array(numbers);

test('y points upwards', () => {
  assert.equal(orientation([0, 0], [1, 0], [0, 1]), 1);
  assert.equal(inCircle([1, 0, 1], [0, 0], [1, 0], [0, 1], [0.5, 0.5]), 1);
});

test('orient2d and incircle have the signs of robust-predicates', () => {
  assert.equal(predicates.orient2d(0, 0, 1, 0, 0, 1), -1);
  assert.ok(predicates.incircle(0, 0, 1, 0, 0, 1, 0.5, 0.5) > 0);
  assert.equal(predicates.incircle(0, 0, 1, 0, 1, 1, 0, 1), 0);
  assert.ok(Number.isNaN(predicates.orient2d(0, 0, 1, 0, 0, NaN)));
  assert.ok(Number.isNaN(predicates.incircle(0, 0, 1, 0, 1, 1, 0, Infinity)));
  // Twice the area underflows; the sign does not.
  assert.ok(predicates.orient2d(0, 0, 2 ** -600, 0, 0, 2 ** -600) < 0);
  assert.equal(predicates.orient2d(0, 0, 2 ** 600, 0, 0, 2 ** 600), -Infinity);
});

test('arguments are lists of any kind, or numbers', () => {
  assert.equal(orientation(0, 0, 1, 0, 0, 1), 1);
  assert.equal(orientation(table(0, 0), [1, 0], new Float32Array([0, 1])), 1);
  const wide = [1, 0, 4];
  assert.equal(edgeTest([0, 0, ...wide], [1, 0, ...wide], [0.5, -1, ...wide], [0.5, 1, ...wide]), true);
  assert.equal(compareDistance(0, 0, 1, 0, 1, 2, 0, 1, 0, 1, 1, 0), 0);
});

test('what has another shape is a TypeError', () => {
  assert.throws(() => orientation([0, 0], [1, 0]), /orientation: takes 3 arguments, not 2/);
  assert.throws(() => orientation([0, 0], [1, 0], [0, 1, 2]), /argument 3 is not a point x y/);
  assert.throws(() => orientation([0, 0], [1, 0], undefined), TypeError);
  assert.throws(() => orientation([0, 0], [1, 0], ['0', 1]), /0 is not a number/);
  assert.throws(() => orientation(0, 0, 1, 0, 0), /takes 6 numbers, not 5/);
  assert.throws(() => orientations(table(0, 0), table(1, 0), [0, 1]), /argument 3 is not a Float64Array/);
  assert.throws(() => orientations(table(0, 0), table(1, 0), table(0, 1, 2)), /3 numbers; each row is a point/);
  assert.throws(() => orientations(table(0, 0, 1, 1), table(1, 0), table(0, 1, 2, 2, 3, 3)),
                /argument 3 has 3 rows, argument 1 has 2/);
  assert.throws(() => explain('orient3d', [0, 0]), /no predicate 'orient3d'/);
});

test('what no predicate can be asked is a RangeError, which says the row', () => {
  assert.throws(() => orientation([0, 0], [1, 0], [0, NaN]), RangeError);
  assert.throws(() => edgeTest([0, 0, 1, 0, 1], [0, 0, 2, 0, 1], [1, 0, 1, 0, 1], [0, 1, 1, 0, 1]), /same position/);
  assert.throws(() => inCircle([1, 1, 1], [0, 0], [1, 0], [0, 1], [1, 1]), /not positive definite/);
  // An error behind the first block of a table.
  const rows = 20000;
  const r = new Float64Array(2 * rows).fill(1);
  r[2 * 19990] = Infinity;
  assert.throws(() => orientations(table(0, 0), table(1, 0), r), /orientations: row 19990: a number is infinite/);
});

test('a table of one row stands for itself in every question', () => {
  assert.deepEqual(orientations(table(0, 0), table(1, 0), table(0, 1, 0.5, 0, 0, -1)), Int8Array.of(1, 0, -1));
  assert.deepEqual(orientations(table(0, 0), table(1, 0), table(0, 1)), Int8Array.of(1));
  assert.deepEqual(orientations(table(), table(), table()), new Int8Array(0));
  assert.deepEqual(orientations(table(0, 0), table(), table(1, 0)), new Int8Array(0));
});

test('long tables are answered as questions are, one by one', () => {
  const rows = 5000;
  const sites = Array.from({ length: 4 }, (_, k) => Float64Array.from({ length: 5 * rows }, (__, i) => {
    const row = Math.floor(i / 5);
    return [(row * (k + 3)) % 7 + k / 8, (row * (k + 5)) % 11, 1 + ((row + k) % 3), 0.25, 2][i % 5];
  }));
  const many = edgeTests(...sites);
  for (let row = 0; row < rows; row += 7) {
    const one = edgeTest(...sites.map((column) => column.subarray(5 * row, 5 * row + 5)));
    assert.equal(many[row], Number(one));
  }
});

test('the tier that decided is told', () => {
  predicates.resetCounters();
  assert.deepEqual(explain('orientation', [0, 0], [1, 0], [0, 1]), { answer: 1, tier: 'semiStatic' });
  assert.deepEqual(explain('orientation', [0, 0], [1, 1], [2, 2]), { answer: 0, tier: 'exact' });
  predicates.orient2d(0, 0, 1, 0, 0, 1);
  orientations(table(0, 0), table(1, 0), table(0, 1, 0.5, 0, 0, -1));
  assert.deepEqual(predicates.counters().orientation, { semiStatic: 4, interval: 0, exact: 2 });
  predicates.resetCounters();
  assert.deepEqual(predicates.counters().orientation, { semiStatic: 0, interval: 0, exact: 0 });
});

test('import and require share an instance; api makes others', async () => {
  const required = require('asterism-predicates');
  assert.equal(required.orientation, orientation);
  assert.deepEqual(Object.keys(required).sort(), Object.keys(predicates).filter((k) => k !== 'default').sort());
  const bytes = readFileSync(require.resolve('asterism-predicates/predicates.wasm'));
  for (const made of [await create(bytes), createSync(new WebAssembly.Module(bytes)),
                      require('asterism-predicates/api').createSync(new WebAssembly.Module(bytes))]) {
    assert.equal(made.orientation([0, 0], [1, 0], [0, 1]), 1);
    assert.equal(made.counters().orientation.semiStatic, 1);
  }
  assert.equal(predicates.version, require('asterism-predicates/package.json').version);
});
