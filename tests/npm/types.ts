// SPDX-License-Identifier: MIT
//
// Compiles if the types of asterism-predicates are what its users need, and no wider.
import { orientation, edgeTest, edgeTests, explain, counters, orient2d, Predicates } from 'asterism-predicates';
import { create } from 'asterism-predicates/api';

const turn: -1 | 0 | 1 = orientation([0, 0], [1, 0], new Float64Array([0, 1]));
const flat: -1 | 0 | 1 = orientation(0, 0, 1, 0, 0, 1);
const edge: boolean = edgeTest([0, 0, 1, 0, 1], [1, 0, 1, 0, 1], [0, 1, 1, 0, 1], [1, 1, 1, 0, 1]);
const table = new Float64Array(5);
const many: Int8Array = edgeTests(table, table, table, table);
const tier: 'semiStatic' | 'interval' | 'exact' = explain('inWedge', [0], [1], [2]).tier;
const exact: number = counters().edgeTest.exact;
const area: number = orient2d(0, 0, 1, 0, 0, 1);
const made: Promise<Predicates> = create(new Uint8Array(8));
// @ts-expect-error: a table is no list of lists
edgeTests([[0]], table, table, table);
// @ts-expect-error: there is no such predicate
explain('orient3d', [0]);
export { turn, flat, edge, many, tier, exact, area, made };
