// SPDX-License-Identifier: MIT
//
// The questions of bench/npm/predicates.cpp asked of asterism-predicates:
//     node predicates.mjs FOLDER
// Prints NAME, route, predicate, nanoseconds of processor time a question and the sum of the answers.
import { readFileSync } from 'node:fs';
import * as predicates from 'asterism-predicates';

const QUESTIONS = {
  orientation: ['orientations', [2, 2, 2]], compareDistance: ['compareDistances', [5, 5, 2]],
  dominates: ['dominations', [5, 5, 2]], inWedge: ['inWedges', [5, 5, 2]],
  encroaches: ['encroachments', [5, 5, 5]], edgeTest: ['edgeTests', [5, 5, 5, 5]],
};

function nanoseconds() {
  const { user, system } = process.cpuUsage();
  return 1000 * (user + system);
}

function bestOfFive(answer) {
  let best = Infinity, sum = 0;
  for (let turn = 0; turn < 5; ++turn) {
    const begin = nanoseconds();
    sum = answer();
    best = Math.min(best, nanoseconds() - begin);
  }
  return [best, sum];
}

for (const kind of ['smooth', 'ties']) {
  const bytes = readFileSync(`${process.argv[2]}/${kind}.bin`);
  const numbers = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
  const rows = numbers.length / 20;
  for (const [one, [many, widths]] of Object.entries(QUESTIONS)) {
    const tables = widths.map((width, k) => Float64Array.from({ length: width * rows },
      (_, i) => numbers[20 * Math.floor(i / width) + 5 * k + i % width]));
    const questions = Array.from({ length: rows },
      (_, row) => tables.map((table, k) => table.subarray(row * widths[k], (row + 1) * widths[k])));
    const flat = questions.map((question) => question.flatMap((part) => [...part]));
    const say = (route, [time, sum]) => console.log(kind, route, one, (time / rows).toFixed(1), sum);
    say('one', bestOfFive(() => questions.reduce((sum, question) => sum + Number(predicates[one](...question)), 0)));
    say('many', bestOfFive(() => predicates[many](...tables).reduce((sum, answer) => sum + answer, 0)));
    if (one === 'orientation')
      say('orient2d', bestOfFive(() => {
        let sum = 0;
        for (const [ax, ay, bx, by, cx, cy] of flat) sum -= Math.sign(predicates.orient2d(ax, ay, bx, by, cx, cy));
        return sum;
      }));
  }
}
