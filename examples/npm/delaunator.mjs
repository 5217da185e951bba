// SPDX-License-Identifier: MIT
//
// Delaunator with other predicates: who is wrong how often?
//     node delaunator.mjs
// prints a table in Markdown. scripts/challenge-npm fetches what this imports. Each triangulation is judged by
// exact signs: triangles that are flat or inverted, edges that are not Delaunay, points beyond the hull, points
// without a triangle. Runs are ended after a minute, since wrong signs can have a program go in circles.
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import * as exact from 'asterism-predicates';

// Delaunator imports orient2d from robust-predicates, and has an in-circle test in doubles of its
// own.
const VARIANTS = {
  'doubles': ['{orient2dfast as orient2d, incirclefast as incircle} from "robust-predicates"', false],
  'robust-predicates, as published': ['{orient2d, incircle} from "robust-predicates"', false],
  'asterism-predicates': ['{orient2d, incircle} from "asterism-predicates"', false],
  'robust-predicates, in-circle too': ['{orient2d, incircle} from "robust-predicates"', true],
  'asterism-predicates, in-circle too': ['{orient2d, incircle} from "asterism-predicates"', true],
};

let state = 1;
// Returns a number in [0, 1) (a generator of Park and Miller).
function random() {
  state = (state * 48271) % 2147483647;
  return state / 2147483647;
}
const whole = (least, most) => least + Math.floor(random() * (most - least + 1));
const repeated = (count, make) => Array.from({ length: count }, (_, k) => make(k));

// Lists of points, x and y in turn. delaunator identifies points closer than 2^-52; here none are.
const INPUTS = {
  'grid of neighbouring doubles, and two points far along its diagonal': () => {
    const unit = 2 ** -49, x = 8 + whole(0, 1000) / 1024; // unit: of the last place of 8 to 16
    return [...repeated(100, (k) => [x + unit * (k % 10), x + unit * Math.floor(k / 10)]), [12, 12], [24, 24]].flat();
  },
  'points within a unit of the last place of a line': () => {
    const slope = random(), from = 16 + 8 * random();
    return repeated(100, (k) => {
      const x = 32 + k / 7, y = from + slope * x;
      return [x, y * (1 + whole(-1, 1) * 2 ** -52)];
    }).flat();
  },
  'whole numbers in a grid': () => {
    const step = whole(1, 9);
    return repeated(400, (k) => [step * (k % 20), step * Math.floor(k / 20)]).flat();
  },
  'a grid turned by some angle': () => {
    const angle = random(), c = Math.cos(angle), s = Math.sin(angle);
    return repeated(400, (k) => {
      const u = k % 20, v = Math.floor(k / 20);
      return [c * u - s * v, s * u + c * v];
    }).flat();
  },
  'points at random': () => repeated(800, random),
};
const SETS = 100;

// Returns Delaunator with other predicates: its source with other imports.
async function delaunatorWith([imports, inCircleToo], name) {
  const source = readFileSync(new URL('./node_modules/delaunator/index.js', import.meta.url), 'utf8');
  const other = source.replace(/^import .*robust-predicates.*$/m, `import ${imports};`);
  const changed = inCircleToo
    ? other.replace(/function inCircle\(([^)]*)\) \{[^]*?\n\}/, 
                    'function inCircle($1) {\n    return incircle($1) < 0;\n}')
    : other;
  if (other === source || (inCircleToo && changed === other)) throw new Error('delaunator is not as expected');
  const file = `delaunator-${name.replace(/\W+/g, '-')}.mjs`;
  writeFileSync(new URL(file, import.meta.url), changed);
  return (await import(`./${file}`)).default;
}

// Rows of points for a table.
function rows(points, indices) {
  return Float64Array.from({ length: 2 * indices.length }, (_, k) => points[2 * indices[k >> 1] + (k & 1)]);
}
const count = (answers, is) => answers.reduce((sum, answer) => sum + is(answer), 0);

function judge(points, { triangles, halfedges, hull }) {
  const corner = (k) => triangles.filter((_, t) => t % 3 === k);
  const turns = exact.orientations(rows(points, corner(0)), rows(points, corner(1)), rows(points, corner(2)));
  // Delaunator's triangles turn clockwise with y upwards.
  const badTriangles = count(turns, (turn) => turn !== -1);
  const next = (e) => (e % 3 === 2 ? e - 2 : e + 1);
  const inner = [...halfedges.keys()].filter((e) => halfedges[e] > e);
  const at = (of) => rows(points, inner.map(of));
  const plane = new Float64Array([1, 0, 1]);
  const circles = inner.length === 0 ? [] : exact.inCircles(plane, at((e) => triangles[e]), at((e) => triangles[next(e)]),
    at((e) => triangles[next(next(e))]), at((e) => triangles[next(next(halfedges[e]))]));
  const badEdges = count(circles, (place) => place < 0);
  const all = [...Array(points.length / 2).keys()];
  const outside = new Set();
  for (let k = 0; k < hull.length; ++k) {
    const from = rows(points, [hull[k]]), to = rows(points, [hull[(k + 1) % hull.length]]);
    exact.orientations(from, to, points).forEach((turn, i) => { if (turn > 0) outside.add(i); });
  }
  const used = new Set(triangles);
  return [badTriangles, badEdges, outside.size, all.filter((i) => !used.has(i)).length];
}

async function measure(variant, input) {
  const Delaunator = await delaunatorWith(VARIANTS[variant], variant);
  state = 1;
  const sum = [0, 0, 0, 0];
  let wrong = 0, failed = 0;
  for (let set = 0; set < SETS; ++set) {
    const points = Float64Array.from(INPUTS[input]());
    let found;
    try {
      found = judge(points, new Delaunator(points));
    } catch {
      ++failed;
      continue;
    }
    found.forEach((n, k) => { sum[k] += n; });
    wrong += found.some((n) => n > 0);
  }
  return { wrong: wrong + failed, failed, sum };
}

if (process.argv.length > 2) {
  console.log(JSON.stringify(await measure(process.argv[2], process.argv[3])));
} else {
  for (const input of Object.keys(INPUTS)) {
    console.log(`| ${input} | wrong | triangles | edges | points outside | points left out |\n|---|--:|--:|--:|--:|--:|`);
    for (const variant of Object.keys(VARIANTS)) {
      const done = spawnSync(process.execPath, [fileURLToPath(import.meta.url), variant, input], { timeout: 60000 });
      if (done.status !== 0) {
        console.log(`| ${variant} | did not end | | | | |`);
        continue;
      }
      const { wrong, failed, sum } = JSON.parse(done.stdout);
      console.log(`| ${variant} | ${wrong}${failed > 0 ? ` (${failed} threw)` : ''} | ${sum.join(' | ')} |`);
    }
    console.log();
  }
}
