// SPDX-License-Identifier: MIT
//
// The mesher and its auditor over the module mesh.wasm. Each job has an instance of its own, whose memory goes
// with it; everything that touches that memory is here. Types and laws: index.d.ts.

// Names in the order of the module's numbers.
const TEXTS = ['failure', 'reason', 'certificate', 'mesh', 'solution', 'witnesses', 'version'];
const DOMAINS = ['square', 'airfoil'];
const OPTIONS = ['size', 'gradation', 'repairDomain', 'repairDistance', 'chordTolerance', 'regions', 'randomPoints', 'strict', 'angleBound',
                 'metricTolerance', 'tol', 'maxSites', 'improve', 'seed', 'proveVoronoi', 'refine'];
const STRATEGIES = ['fill', 'voronoi', 'darts'];
const FLAGS = ['repairDomain', 'regions', 'strict', 'proveVoronoi'];
const WHOLE = { randomPoints: [0, 1000000], maxSites: [3, 100000000], improve: [0, 1000], seed: [0, Number.MAX_SAFE_INTEGER] };

function numbersOf(what, list, width) {
  const numbers = ArrayBuffer.isView(list) ? [...list] : [...list].flat();
  if (numbers.length % width !== 0) throw new TypeError(`${what}: ${numbers.length} numbers are not ${width} each`);
  numbers.forEach((x, i) => {
    if (typeof x !== 'number') throw new TypeError(`${what}: number ${i + 1} is ${String(x)}`);
    if (!Number.isFinite(x)) throw new RangeError(`${what}: number ${i + 1} is ${x}`);
  });
  return numbers;
}

function rowsOf(what, list, width) {
  const numbers = numbersOf(what, list, width);
  return Array.from({ length: numbers.length / width }, (_, i) => numbers.slice(width * i, width * (i + 1)));
}

/** A domain given in numbers as a text in Triangle's .poly format: the fewest digits that give each double again. */
export function polyOf({ points, segments, markers, holes = [], regions = [] }) {
  const vertices = rowsOf('points', points, 2), count = vertices.length;
  const ends = segments ? rowsOf('segments', segments, 2) : vertices.map((_, i) => [i, (i + 1) % count]);
  ends.flat().forEach((v) => { if (!Number.isInteger(v) || v < 0 || v >= count) throw new RangeError(`segments: there is no point ${v}`); });
  if (markers && markers.length !== ends.length) throw new TypeError(`markers: ${markers.length} for ${ends.length} segments`);
  const seeds = rowsOf('regions', regions, 3), lines = [`${count} 2 0 0`, ...vertices.map((p, i) => `${i + 1} ${p.join(' ')}`)];
  lines.push(`${ends.length} 1`, ...ends.map(([a, b], i) => `${i + 1} ${a + 1} ${b + 1} ${markers ? markers[i] : 1}`));
  const points2 = rowsOf('holes', holes, 2);
  lines.push(String(points2.length), ...points2.map((p, i) => `${i + 1} ${p.join(' ')}`));
  if (seeds.length) lines.push(String(seeds.length), ...seeds.map((p, i) => `${i + 1} ${p.join(' ')}`));
  return `${lines.join('\n')}\n`;
}

// Returns the domain's name, and its files.
function domainOf(domain) {
  if (typeof domain === 'string') {
    if (!DOMAINS.includes(domain)) throw new RangeError(`domain: '${domain}' is not one of ${DOMAINS.join(', ')}; files are { name, text }`);
    return { name: domain, files: {} };
  }
  if (typeof domain?.text === 'string' && typeof domain.name === 'string') return { name: domain.name, files: { [domain.name]: domain.text, ...domain.files } };
  if (domain?.points) return { name: 'domain.poly', files: { 'domain.poly': polyOf(domain) } };
  throw new TypeError('domain: takes a name, { points, segments, ... }, or a file { name, text }');
}

function optionsOf(options) {
  const taken = {};
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (!OPTIONS.includes(name)) throw new TypeError(`there is no option '${name}': ${OPTIONS.join(', ')}`);
    const is = (right, what) => { if (!right) throw new RangeError(`${name}: ${String(value)} is not ${what}`); };
    if (name === 'refine') is(STRATEGIES.includes(value), `one of ${STRATEGIES.join(', ')}`);
    else if (FLAGS.includes(name)) is(typeof value === 'boolean', 'true or false');
    else if (WHOLE[name]) is(Number.isInteger(value) && value >= WHOLE[name][0] && value <= WHOLE[name][1], `a whole number from ${WHOLE[name].join(' to ')}`);
    else if (name === 'angleBound') is(value >= 0 && value < 60, 'at least 0 and below 60');
    else if (name === 'metricTolerance') is(value >= 0 && value < Infinity, 'at least 0');
    else if (name === 'gradation') is(value > 1 && value <= 1e6, 'above 1, at most 1000000');
    else is(typeof value === 'number' && value > 0 && value < Infinity, 'positive and finite');
    taken[name] = value;
  }
  return taken;
}

class Instance {
  constructor(module, metric) {
    this.module = module;
    this.metric = metric;
    this.said = '';
  }

  async start() {
    this.exports = (await WebAssembly.instantiate(this.module, this.imports())).exports;
    this.exports._initialize?.();
    return this;
  }
  get buffer() { return this.exports.memory.buffer; }

  imports() {
    const imports = {};
    const known = {
      metric: (count, points, metrics) => this.ask(count, points, metrics),
      emscripten_notify_memory_growth: () => {},
      fd_write: (_, vectors, count, written) => this.write(vectors, count, written),
      clock_time_get: (_, __, at) => { new DataView(this.buffer).setBigUint64(at, 0n, true); return 0; },
      environ_sizes_get: (count, size) => { const view = new DataView(this.buffer); view.setUint32(count, 0, true); view.setUint32(size, 0, true); return 0; },
      environ_get: () => 0,
    };
    for (const { module: from, name } of WebAssembly.Module.imports(this.module)) {
      imports[from] ??= {};
      imports[from][name] = known[name] ?? (() => { throw new Error(`asterism-mesh: the module could not finish (${name})`); });
    }
    return imports;
  }

  // Returns the notes, which the command writes to standard error.
  write(vectors, count, written) {
    const view = new DataView(this.buffer);
    let bytes = 0;
    for (let i = 0; i < count; ++i) {
      const at = view.getUint32(vectors + 8 * i, true), length = view.getUint32(vectors + 8 * i + 4, true);
      this.said += new TextDecoder().decode(new Uint8Array(this.buffer, at, length));
      bytes += length;
    }
    view.setUint32(written, bytes, true);
    return 0;
  }

  // Returns the metric wanted at places, by JavaScript's function. The caller that asked for the
  // mesh gets its exceptions.
  ask(count, points, metrics) {
    try {
      const places = new Float64Array(this.buffer, points, 2 * count).slice(), tensors = new Float64Array(3 * count);
      for (let i = 0; i < count; ++i) {
        const given = this.metric(places[2 * i], places[2 * i + 1]);
        if (given?.length !== 3) throw new TypeError('metric: the function has to return [m11, m12, m22]');
        tensors.set(given, 3 * i);
      }
      new Float64Array(this.buffer, metrics, 3 * count).set(tensors);
      return 0;
    } catch (failure) {
      this.thrown ??= failure;
      return 1;
    }
  }

  run(name, job) {
    const bytes = new TextEncoder().encode(JSON.stringify(job)), at = this.exports.allocate(bytes.length);
    new Uint8Array(this.buffer, at, bytes.length).set(bytes);
    const refused = this.exports[name](at, bytes.length);
    if (this.thrown) throw this.thrown;
    if (refused) throw new RangeError(this.text('failure'));
  }

  text(name) {
    const which = TEXTS.indexOf(name), at = this.exports.text(which);
    return new TextDecoder().decode(new Uint8Array(this.buffer, at, this.exports.textLength(which)).slice());
  }
  array(Type, name, count) {
    return count === 0 ? new Type(0) : new Type(this.buffer, this.exports[name](), count).slice();
  }
  notes() { return this.said.split('\n').filter(Boolean).map((line) => line.replace(/^asterism: note: /, '')); }
  witnesses() { return this.text('witnesses').split('\n').filter(Boolean); }
}

function arraysOf(instance) {
  const { exports } = instance, triangles = exports.triangleCount(), edges = exports.edgeCount();
  return {
    sites: instance.array(Float64Array, 'sites', 5 * exports.siteCount()), triangles: instance.array(Uint32Array, 'triangles', 3 * triangles),
    regions: instance.array(Int32Array, 'regions', triangles), edges: instance.array(Uint32Array, 'edges', 2 * edges),
    markers: instance.array(Int32Array, 'markers', edges),
  };
}

async function mesh(module, domain, metric = 'identity', options = {}) {
  const { name, files } = domainOf(domain), isFunction = typeof metric === 'function';
  if (!isFunction && typeof metric !== 'string') throw new TypeError('metric: takes a specification or a function of x and y');
  const job = { domain: name, files, metric: isFunction ? 'a function' : metric, hasFunction: isFunction, options: optionsOf(options) };
  const instance = await new Instance(module, metric).start();
  instance.run('mesh', job);
  const { exports } = instance;
  return {
    complete: exports.isComplete() !== 0, certified: exports.isCertified() !== 0, reason: instance.text('reason'),
    worstAngle: exports.worstAngle(), witnesses: instance.witnesses(), notes: instance.notes(),
    ...arraysOf(instance),
    files: { mesh: instance.text('mesh'), solution: instance.text('solution'), certificate: instance.text('certificate') },
  };
}

function filesOf({ mesh: text, solution }) {
  if (typeof text !== 'string' || typeof solution !== 'string') throw new TypeError('takes the texts { mesh, solution }, of NAME.mesh and NAME.sol');
  return { 'given.mesh': text, 'given.sol': solution };
}
function verdictOf(instance) {
  const { exports } = instance;
  return { certified: exports.isVerified() !== 0, worstAngle: exports.worstAngle(), witnesses: instance.witnesses(), ...arraysOf(instance) };
}

async function verify(module, files) {
  if (typeof files.certificate !== 'string') throw new TypeError('verify: takes { mesh, solution, certificate }; certify does without a certificate');
  const instance = await new Instance(module).start();
  instance.run('verify', { files: filesOf(files), certificate: files.certificate });
  return verdictOf(instance);
}
async function certify(module, files, { angleBound = 20 } = {}) {
  if (!(angleBound >= 0 && angleBound < 60)) throw new RangeError(`angleBound: ${String(angleBound)} is not at least 0 and below 60`);
  const instance = await new Instance(module).start();
  instance.run('certify', { files: filesOf(files), angleBound });
  return { ...verdictOf(instance), certificate: instance.text('certificate') };
}

/** Makes the functions over a compiled module or the bytes of mesh.wasm. */
export async function create(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const first = await new Instance(module).start();
  return Object.freeze({
    mesh: (domain, metric, options) => mesh(module, domain, metric, options),
    verify: (files) => verify(module, files),
    certify: (files, options) => certify(module, files, options),
    version: first.text('version'),
  });
}
