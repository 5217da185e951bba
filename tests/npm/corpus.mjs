// SPDX-License-Identifier: MIT
//
// Asks a corpus of questions with known answers in every way that asterism-predicates has: on
// lists, on numbers and over tables. Runs in node and in browsers.

// Returns the double that a decimal or C99 hexadecimal text stands for. Both factors are exact, and
// the product is rounded once.
export function numberOf(text) {
  const parts = /^(-?)0x([0-9a-f]+)\.?([0-9a-f]*)p([+-]?\d+)$/i.exec(text);
  if (!parts) return Number(text);
  const [, minus, whole, fraction, power] = parts;
  const exponent = Number(power) - 4 * fraction.length;
  const half = Math.trunc(exponent / 2);
  const magnitude = Number.parseInt(whole + fraction, 16) * 2 ** half * 2 ** (exponent - half);
  return minus ? -magnitude : magnitude;
}

const POINT = 2, METRIC = 3, SITE = 5;
const QUESTIONS = {
  orientation: ['orientation', 'orientations', [POINT, POINT, POINT]],
  orient2d: ['orientation', 'orientations', [POINT, POINT, POINT]],
  is_spd: ['isPositiveDefinite', 'arePositiveDefinite', [METRIC]],
  compare_distance: ['compareDistance', 'compareDistances', [SITE, SITE, POINT]],
  in_wedge: ['inWedge', 'inWedges', [SITE, SITE, POINT]],
  dominates: ['dominates', 'dominations', [SITE, SITE, POINT]],
  voronoi_vertex_count: ['voronoiVertexCount', 'voronoiVertexCounts', [SITE, SITE, SITE]],
  arc_intersection_count: ['arcIntersectionCount', 'arcIntersectionCounts', [SITE, SITE, SITE]],
  encroaches: ['encroaches', 'encroachments', [SITE, SITE, SITE]],
  insertion_test: ['insertionTest', 'insertionTests', [SITE, SITE, SITE, SITE]],
  edge_test: ['edgeTest', 'edgeTests', [SITE, SITE, SITE, SITE]],
  in_circle: ['inCircle', 'inCircles', [METRIC, POINT, POINT, POINT, POINT]],
  incircle: ['inCircle', 'inCircles', [METRIC, POINT, POINT, POINT, POINT]],
};
const PLANE = [1, 0, 1];

// Returns the records of the text: the name of the predicate, its numbers and the answer.
export function recordsOf(text) {
  const records = [];
  for (const line of text.split('\n')) {
    if (line.startsWith('#= ')) {
      records.at(-1).answer = Number(line.slice(3));
    } else if (line !== '' && !line.startsWith('#')) {
      const [name, ...fields] = line.trim().split(/\s+/);
      const numbers = fields.map(numberOf);
      records.push({ name, numbers: name === 'incircle' ? [...PLANE, ...numbers] : numbers });
    }
  }
  return records;
}

function argumentsOf({ name, numbers }) {
  let at = 0;
  return QUESTIONS[name][2].map((width) => numbers.slice(at, at += width));
}

// Asks one question in numbers, and also with robust-predicates' arguments where the function is
// one of that package's.
function otherWaysAlike(predicates, record) {
  const [one] = QUESTIONS[record.name];
  if (Number(predicates[one](...record.numbers)) !== record.answer) return false;
  if (record.name === 'orient2d') return Math.sign(predicates.orient2d(...record.numbers)) === 0 - record.answer;
  if (record.name === 'incircle') return Math.sign(predicates.incircle(...record.numbers.slice(3))) === record.answer;
  return true;
}

// Returns how many questions of one name have other answers over tables.
function tableDifferences(predicates, name, records) {
  const [, many, widths] = QUESTIONS[name];
  const tables = widths.map((width) => new Float64Array(width * records.length));
  records.forEach((record, row) => argumentsOf(record).forEach((part, k) => tables[k].set(part, row * widths[k])));
  return predicates[many](...tables).reduce((sum, answer, row) => sum + (answer !== records[row].answer), 0);
}

// Returns the number of records, the number of wrong answers, and the tiers that decided the
// questions asked singly.
export function askCorpus(predicates, text) {
  const records = recordsOf(text);
  predicates.resetCounters();
  const asked = records.map((record) => Number(predicates[QUESTIONS[record.name][0]](...argumentsOf(record))));
  const tiers = predicates.counters();
  const wrong = records.filter((record, k) => asked[k] !== record.answer || !otherWaysAlike(predicates, record)).length;
  let wrongInTables = 0;
  for (const name of Object.keys(QUESTIONS))
    wrongInTables += tableDifferences(predicates, name, records.filter((record) => record.name === name));
  return { records: records.length, wrong, wrongInTables, tiers };
}
