// SPDX-License-Identifier: MIT
//
// The predicates over an instance of predicates.wasm. Everything that touches the module's memory is
// here; node.cjs, node.mjs and browser.mjs only bring the module. Types and laws: index.d.ts.

const POINT = 2;
const METRIC = 3;
const SITE = 5;
const KINDS = { [POINT]: 'a point x y', [METRIC]: 'a metric m11 m12 m22', [SITE]: 'a site x y m11 m12 m22' };

// Predicates in the order of the module's numbers: name, name of the batch, widths of the
// arguments, whether the answer is a boolean.
const PREDICATES = [
  ['orientation', 'orientations', [POINT, POINT, POINT], false],
  ['isPositiveDefinite', 'arePositiveDefinite', [METRIC], true],
  ['compareDistance', 'compareDistances', [SITE, SITE, POINT], false],
  ['inWedge', 'inWedges', [SITE, SITE, POINT], true],
  ['dominates', 'dominations', [SITE, SITE, POINT], false],
  ['voronoiVertexCount', 'voronoiVertexCounts', [SITE, SITE, SITE], false],
  ['arcIntersectionCount', 'arcIntersectionCounts', [SITE, SITE, SITE], false],
  ['encroaches', 'encroachments', [SITE, SITE, SITE], true],
  ['insertionTest', 'insertionTests', [SITE, SITE, SITE, SITE], true],
  ['edgeTest', 'edgeTests', [SITE, SITE, SITE, SITE], true],
  ['inCircle', 'inCircles', [METRIC, POINT, POINT, POINT, POINT], false],
];
const TIERS = ['semiStatic', 'interval', 'exact'];
const REFUSAL_BASE = -16;  // as in entry.cpp: a refusal is this number minus its status

// The module's only import: ends the program when it cannot finish.
function importsOf(module) {
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = name === 'emscripten_notify_memory_growth'
      ? () => {}
      : () => { throw new Error(`asterism-predicates: the module could not finish (${name})`); };
  }
  return imports;
}

class Module {
  constructor(instance) {
    this.exports = instance.exports;
    this.exports._initialize?.();
    this.room = this.exports.room();
    this.view();
  }

  view() {
    const { memory, numbers, answers } = this.exports;
    this.numbers = new Float64Array(memory.buffer, numbers(), this.room);
    this.answers = new Int8Array(memory.buffer, answers(), this.room);
  }

  // Makes the views anew after the memory has grown, which leaves the old views empty.
  viewed() {
    if (this.numbers.length === 0) this.view();
    return this;
  }

  // Returns a copy of the counts, a row of tiers for each predicate.
  decided() {
    const { memory, decided } = this.exports;
    return new Float64Array(memory.buffer, decided(), PREDICATES.length * TIERS.length).slice();
  }

  text(address) {
    const bytes = new Uint8Array(this.exports.memory.buffer, address);
    return String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
  }
}

function checkedNumber(name, x) {
  if (typeof x !== 'number') throw new TypeError(`${name}: ${String(x)} is not a number`);
  return x;
}

function refuseShape(name, k, width) {
  throw new TypeError(`${name}: argument ${k + 1} is not ${KINDS[width]}`);
}

// Writes argument k, a list, to `numbers` from `at` on. Unrolled: it is most of a quick question's time.
function writeList(numbers, at, list, width, name, k) {
  if (list === undefined || list === null || list.length !== width) refuseShape(name, k, width);
  numbers[at] = checkedNumber(name, list[0]);
  numbers[at + 1] = checkedNumber(name, list[1]);
  if (width === POINT) return;
  numbers[at + 2] = checkedNumber(name, list[2]);
  if (width === METRIC) return;
  numbers[at + 3] = checkedNumber(name, list[3]);
  numbers[at + 4] = checkedNumber(name, list[4]);
}

function writeNumbers(numbers, given, total, name) {
  if (given.length !== total) throw new TypeError(`${name}: takes ${total} numbers, not ${given.length}`);
  for (let k = 0; k < total; ++k) numbers[k] = checkedNumber(name, given[k]);
}

// Returns the function of one predicate. Its arguments are all numbers one after another, or a list each.
function asker(module, question) {
  const [name, , widths, isTruth] = PREDICATES[question];
  const [first, second, third, fourth, fifth] = widths;
  const total = widths.reduce((sum, width) => sum + width, 0);
  const { ask } = module.exports;
  return function (a, b, c, d, e) {
    const { numbers } = module.viewed();
    if (typeof a === 'number') {
      writeNumbers(numbers, arguments, total, name);
    } else {
      if (arguments.length !== widths.length)
        throw new TypeError(`${name}: takes ${widths.length} arguments, not ${arguments.length}`);
      writeList(numbers, 0, a, first, name, 0);
      if (second) writeList(numbers, first, b, second, name, 1);
      if (third) writeList(numbers, first + second, c, third, name, 2);
      if (fourth) writeList(numbers, first + second + third, d, fourth, name, 3);
      if (fifth) writeList(numbers, first + second + third + fourth, e, fifth, name, 4);
    }
    const answer = ask(question);
    if (answer <= REFUSAL_BASE)
      throw new RangeError(`${name}: ${module.text(module.exports.message(REFUSAL_BASE - answer))}`);
    return isTruth ? answer === 1 : answer;
  };
}

// Returns the number of questions of a batch. A table of one row is repeated for every question.
function rowCount(name, widths, tables) {
  if (tables.length !== widths.length)
    throw new TypeError(`${name}: takes ${widths.length} tables, not ${tables.length}`);
  let count = 1;
  let from = -1;
  tables.forEach((table, k) => {
    if (!(table instanceof Float64Array)) throw new TypeError(`${name}: argument ${k + 1} is not a Float64Array`);
    const rows = table.length / widths[k];
    if (!Number.isInteger(rows))
      throw new TypeError(`${name}: argument ${k + 1} has ${table.length} numbers; each row is ${KINDS[widths[k]]}`);
    if (rows === 1) return;
    if (from >= 0 && rows !== count)
      throw new TypeError(`${name}: argument ${k + 1} has ${rows} rows, argument ${from + 1} has ${count}`);
    count = rows;
    from = k;
  });
  return count;
}

function batchAsker(module, question) {
  const [, name, widths] = PREDICATES[question];
  return (...tables) => {
    const count = rowCount(name, widths, tables);
    const isConstant = widths.map((width, k) => tables[k].length === width);
    const fixed = widths.reduce((sum, width, k) => sum + (isConstant[k] ? width : 0), 0);
    const each = widths.reduce((sum, width, k) => sum + (isConstant[k] ? 0 : width), 0);
    const most = each === 0 ? 1 : Math.floor((module.room - fixed) / each);
    const bits = isConstant.reduce((sum, is, k) => sum | (is ? 1 << k : 0), 0);
    const found = new Int8Array(count);
    for (let first = 0; first < count; first += most) {
      const rows = Math.min(most, count - first);
      const { numbers } = module.viewed();
      let at = 0;
      widths.forEach((width, k) => {
        const part = isConstant[k] ? tables[k] : tables[k].subarray(first * width, (first + rows) * width);
        numbers.set(part, at);
        at += part.length;
      });
      const status = module.exports.askMany(question, rows, bits);
      if (status !== 0) {
        const row = first + module.exports.failedRow();
        throw new RangeError(`${name}: row ${row}: ${module.text(module.exports.message(status))}`);
      }
      found.set(module.viewed().answers.subarray(0, rows), first);
    }
    return found;
  };
}

function counters(module) {
  const decided = module.decided();
  return Object.fromEntries(PREDICATES.map(([name], p) => [
    name, Object.fromEntries(TIERS.map((tier, t) => [tier, decided[p * TIERS.length + t]]))]));
}

function explain(module, predicates, name, given) {
  const question = PREDICATES.findIndex(([known]) => known === name);
  if (question < 0) throw new TypeError(`explain: there is no predicate '${name}'`);
  const before = module.decided();
  const answer = predicates[name](...given);
  const decided = module.decided();
  const tier = TIERS.find((_, t) => decided[question * TIERS.length + t] !== before[question * TIERS.length + t]);
  return { answer, tier };
}

function predicatesOf(instance) {
  const module = new Module(instance);
  const predicates = {
    orient2d: module.exports.orient2d,
    incircle: module.exports.incircle,
    counters: () => counters(module),
    resetCounters: () => module.exports.resetCounters(),
    explain: (name, ...given) => explain(module, predicates, name, given),
    version: module.text(module.exports.version()),
  };
  PREDICATES.forEach(([one, many], question) => {
    predicates[one] = asker(module, question);
    predicates[many] = batchAsker(module, question);
  });
  return Object.freeze(predicates);
}

/** Makes predicates of a compiled module, at once. Browsers may refuse that on the page's own thread. */
export function createSync(module) {
  return predicatesOf(new WebAssembly.Instance(module, importsOf(module)));
}

/** Makes predicates of a compiled module or of the bytes of predicates.wasm. */
export async function create(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  return predicatesOf(await WebAssembly.instantiate(module, importsOf(module)));
}
