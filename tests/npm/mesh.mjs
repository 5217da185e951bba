// SPDX-License-Identifier: MIT
//
// Runs asterism-mesh as installed, in node. Writes the texts of the files that the jobs of a file
// make, and then checks the package's own functions. node mesh.mjs JOBS.json ANSWERS.json
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { mesh, verify, certify, version } from 'asterism-mesh';

const jobs = JSON.parse(readFileSync(process.argv[2], 'utf8')), answers = [];
for (const { domain, metric, options } of jobs) {
  const made = await mesh(domain, metric, options);
  answers.push({ ...made.files, complete: made.complete, certified: made.certified });
}
writeFileSync(process.argv[3], JSON.stringify(answers));

const L = { points: [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]] };
const made = await mesh(L, 'sink:6', { size: 0.2, angleBound: 22 });
assert(made.complete && made.certified && made.worstAngle >= 22);
assert.equal(made.triangles.length, 3 * made.regions.length);
assert.equal(made.sites.length % 5, 0);
assert.equal(made.edges.length, 2 * made.markers.length);
assert.match(version, /^\d+\.\d+\.\d+/);

// The mesh and its certificate are verified. A spoiled mesh is refused, with the witness.
assert.deepEqual((await verify(made.files)).certified, true);
const spoiled = made.files.mesh.replace(/\nVertices\n(\d+)\n\S+/, '\nVertices\n$1\n0.0625');
assert.notEqual(spoiled, made.files.mesh);
const refused = await verify({ ...made.files, mesh: spoiled });
assert.equal(refused.certified, false);
assert(refused.witnesses.length > 0);
const asked = await certify(made.files, { angleBound: 22 });
assert(asked.certified && asked.certificate.includes('"certified"'));
assert.equal((await certify(made.files, { angleBound: 50 })).certified, false);

// A metric that is a function of the caller: its exceptions are passed on, and wrong results are
// refused.
assert((await mesh('square', (x, y) => [1 + 4 * x * x, 0, 1 + y * y], { size: 0.3 })).certified);
await assert.rejects(mesh('square', () => { throw new Error('mine'); }, { size: 0.3 }), /^Error: mine$/);
await assert.rejects(mesh('square', () => [1, 0], { size: 0.3 }), TypeError);
await assert.rejects(mesh('square', () => [1, 5, 1], { size: 0.3 }), RangeError);

// Wrong arguments are refused with the command's own messages, or for their shape.
await assert.rejects(mesh({ points: [[0, 0], [1, 1], [1, 0], [0, 1]] }, 'identity'), { name: 'RangeError', message: /cross/ });
await assert.rejects(mesh('square', 'no such metric'), RangeError);
await assert.rejects(mesh('square', 'expr:1;0;x²'), { name: 'RangeError', message: /M22: 'x²': unexpected '²' \(position 2\)/ });
await assert.rejects(mesh('square', `expr:1;0;${'('.repeat(1000000)}`), { name: 'RangeError', message: /more than 200 levels/ });
await assert.rejects(mesh('circle'), RangeError);
await assert.rejects(mesh('square', 'identity', { sizes: 1 }), { name: 'TypeError', message: /there is no option 'sizes'/ });
for (const [name, value] of [['size', 0], ['size', NaN], ['angleBound', 60], ['angleBound', '20a'], ['refine', 'best'], ['maxSites', 2.5], ['improve', -1], ['strict', 1]])
  await assert.rejects(mesh('square', 'identity', { [name]: value }), { name: 'RangeError', message: new RegExp(`^${name}: `) });
await assert.rejects(mesh({ points: [[0, 0], [1, 0], [NaN, 1]] }), RangeError);
await assert.rejects(mesh({ points: [[0, 0], [1, 0], [0, 1]], segments: [[0, 3]] }), RangeError);
await assert.rejects(verify({ mesh: 'nonsense', solution: '', certificate: '{}' }), RangeError);
await assert.rejects(verify({ ...made.files, certificate: '{"a": [' }), RangeError);
await assert.rejects(verify({ ...made.files, certificate: '{"mesh": 7}' }), RangeError);

const file = await mesh({ name: 'a.wkt', text: 'POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0), (1 0.5, 1 1.5, 2 1.5, 2 0.5, 1 0.5))' }, 'identity', { size: 0.4 });
assert(file.certified);

const required = createRequire(import.meta.url)('asterism-mesh');
assert((await required.mesh('square')).certified);

const began = performance.now(), large = await mesh('square', 'swirl:12', { size: 0.0437 });
assert(large.certified);
console.log(`${large.triangles.length / 3} triangles in ${((performance.now() - began) / 1000).toFixed(2)} s of node`);
