// SPDX-License-Identifier: MIT
//
// Compares orient2d and incircle with robust-predicates': equal signs on near ties, and values that
// differ by rounding only.
import assert from 'node:assert/strict';
import * as ours from 'asterism-predicates';
import * as robust from 'robust-predicates';

let state = 45;
// Returns a number in [0, 1) (a generator of Park and Miller).
function random() {
  state = (state * 48271) % 2147483647;
  return state / 2147483647;
}

// Draws points on lines and circles of whole numbers, some moved by a unit in the last place.
function near(x) {
  const off = Math.floor(3 * random()) - 1;
  return x + off * Math.abs(x) * 2 ** -52;
}
const whole = (most) => Math.floor(most * random());

let zeros = 0, questions = 0;
for (let i = 0; i < 100000; ++i) {
  const dx = 1 + whole(50), dy = 1 + whole(50), s = whole(20), t = whole(20), x = whole(9) / 8, y = whole(9) / 8;
  const line = [x, y, near(x + s * dx), near(y + s * dy), near(x - t * dx), near(y - t * dy)];
  // Two sides of a rectangle around the middle (x, y), and the fourth corner.
  const circle = [x - dx, y - dy, x + dx, y - dy, near(x + dx), near(y + dy), near(x - dx), near(y + dy)];
  for (const [name, given] of [['orient2d', line], ['incircle', circle]]) {
    const mine = ours[name](...given), theirs = robust[name](...given);
    assert.ok(Math.sign(mine) === Math.sign(theirs), `${name}(${given}): ${mine}, not ${theirs}`);
    zeros += mine === 0;
    ++questions;
  }
  const clear = [random(), random(), random(), random(), random(), random()];
  const mine = ours.orient2d(...clear), theirs = robust.orient2d(...clear);
  assert.ok(Math.abs(mine - theirs) <= 1e-15, `orient2d(${clear})`);
}
assert.ok(zeros > 1000);
console.log(`orient2d and incircle: ${questions} signs as robust-predicates', ${zeros} of them 0`);
